#include "numerics/threads.h"

#include "numerics/blas.h"

namespace vasorod {
namespace {

thread_local int chosen = 1;

}  // namespace

void set_threads(int count) {
  require_blas_buffers(std::max(count, 1));
  chosen = std::max(count, 1);
}

int threads() {
  return chosen;
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
