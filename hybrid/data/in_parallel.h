// Work that several threads share.
#pragma once

#include <algorithm>
#include <atomic>
#include <exception>
#include <functional>
#include <mutex>

#include "data/crew.h"

namespace vasorod {

/// Calls `task` with 0 ... `count` - 1, on up to `threads` threads, of which the calling one is
/// one; on it alone where it is at such work already. After all threads have ended, rethrows the
/// exception that the first task in order threw.
template <class Task>
void in_parallel(int threads, int count, Task task) {
  threads = std::min(threads, count);
  if (threads <= 1) {
    for (int i = 0; i < count; ++i) task(i);
    return;
  }
  std::atomic<int> next = 0;
  std::exception_ptr failure;
  int failed = count;  // tasks are begun in order: all before the first that fails are done
  std::mutex one;
  const auto work = [&] {
    int i = 0;
    try {
      for (i = next++; i < count; i = next++) task(i);
    } catch (...) {
      next = count;
      const std::lock_guard<std::mutex> alone(one);
      if (i >= failed) return;
      failed = i;
      failure = std::current_exception();
    }
  };
  Crew::mine().run(threads - 1, std::ref(work));
  if (failure) std::rethrow_exception(failure);
}

}  // namespace vasorod
