// The threads of a solve, and work shared between them.
#pragma once

#include <algorithm>
#include <atomic>
#include <exception>
#include <functional>
#include <future>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace vasorod {

/// Sets how many threads the solves use that the calling thread begins, at least 1; 1 by default.
/// Throws std::bad_alloc where the BLAS's buffers for them do not fit into the memory.
void set_threads(int count);
int threads();

/// Sets that threads() is `*count` where that is more and the BLAS's buffers for them fit into the
/// memory: another thread or process may change it while a solve runs. nullptr: no longer. `*count`
/// must outlive its use.
void follow_threads(const std::atomic<int>* count);

/// The processors of this machine, 1 to 64.
int processors();

/// Begins `task` on a thread beside those of the calling one, where these are more than one. get()
/// waits for its end and rethrows what it threw; the future's destructor waits as well. Where there
/// is one thread only, or the system gives no other or no memory for it, nothing is begun and the
/// future is not valid().
std::future<void> in_background(std::function<void()> task);

/// Calls `task` with 0 ... `count` - 1, on up to `threads` threads, of which the calling one is
/// one. After all threads have ended, rethrows the exception that the first task in order threw.
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
  {
    std::vector<std::jthread> others;
    try {
      for (int t = 1; t < threads; ++t) others.emplace_back(work);
    } catch (const std::system_error&) {
      // The system gives no more: those that are there do it all.
    }
    work();
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace vasorod
