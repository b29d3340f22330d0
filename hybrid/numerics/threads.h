// The threads of a solve; data/in_parallel.h shares work between them.
#pragma once

#include <atomic>
#include <functional>
#include <future>

#include "data/in_parallel.h"

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

}  // namespace vasorod
