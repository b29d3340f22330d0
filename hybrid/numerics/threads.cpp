#include "numerics/threads.h"

#include "numerics/blas.h"

namespace vasorod {
namespace {

thread_local int chosen = 1;
thread_local const std::atomic<int>* followed = nullptr;
thread_local int with_buffers = 1;  // threads that the BLAS was found to have buffers for

bool find_buffers(int count) {
  if (count <= with_buffers) return true;
  try {
    require_blas_buffers(count);
  } catch (const std::bad_alloc&) {
    return false;
  }
  with_buffers = count;
  return true;
}

}  // namespace

void set_threads(int count) {
  require_blas_buffers(std::max(count, 1));
  chosen = std::max(count, 1);
}

int threads() {
  const int more = followed ? followed->load(std::memory_order_relaxed) : 1;
  return more > chosen && find_buffers(more) ? more : chosen;
}

void follow_threads(const std::atomic<int>* count) {
  followed = count;
}

std::future<void> in_background(std::function<void()> task) {
  if (threads() == 1) return {};
  try {
    require_blas_buffers(threads() + 1);
    return std::async(std::launch::async, std::move(task));
  } catch (const std::system_error&) {
    return {};
  } catch (const std::bad_alloc&) {
    return {};
  }
}

int processors() {
  return std::clamp(static_cast<int>(std::thread::hardware_concurrency()), 1, 64);
}

}  // namespace vasorod
