#include "app/stop.h"

#include <atomic>
#include <chrono>
#include <csignal>
#include <unistd.h>

#include "predict/name_stop.h"
#include "result/folder_replacement.h"

namespace vasorod {
namespace {

std::atomic<bool> signalled{false};
static_assert(std::atomic<bool>::is_always_lock_free,
              "a signal handler may only touch lock-free atomics");

extern "C" void end_now(int signal) {
  // While a result is being put in place, the process is about to end by itself.
  if (remove_unfinished_folder()) _exit(128 + signal);
}

extern "C" void raise_flag(int signal) {
  if (signalled.exchange(true)) end_now(signal);
}

void on_signals(void (*handler)(int)) {
  std::signal(SIGINT, handler);
  std::signal(SIGTERM, handler);
  if (std::signal(SIGHUP, handler) == SIG_IGN) std::signal(SIGHUP, SIG_IGN);
}

}  // namespace

std::function<bool()> stop_on_signal_or_after(double seconds) {
  on_signals(raise_flag);
  const auto begin = std::chrono::steady_clock::now();
  return [begin, seconds] {
    if (signalled.load()) return true;
    return seconds > 0 &&
           std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count() >
               seconds;
  };
}

std::string stopped_by_signal_or(double seconds) {
  return signalled.load() ? "a signal" : time_limit_of(seconds);
}

void end_on_signal() {
  on_signals(end_now);
}

}  // namespace vasorod
