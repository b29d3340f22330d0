#include "app/stop.h"

#include <atomic>
#include <chrono>
#include <csignal>

namespace vasorod {
namespace {

std::atomic<bool> signalled{false};
static_assert(std::atomic<bool>::is_always_lock_free,
              "a signal handler may only touch lock-free atomics");

extern "C" void raise_flag(int) {
  signalled.store(true);
}

}  // namespace

std::function<bool()> stop_on_signal_or_after(double seconds) {
  std::signal(SIGINT, raise_flag);
  std::signal(SIGTERM, raise_flag);
  const auto begin = std::chrono::steady_clock::now();
  return [begin, seconds] {
    if (signalled.load()) return true;
    return seconds > 0 &&
           std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count() >
               seconds;
  };
}

}  // namespace vasorod
