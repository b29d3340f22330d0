#include "app/watchdog.h"

#include <algorithm>
#include <iostream>
#include <optional>
#include <unistd.h>
#include <utility>

namespace vasorod {
namespace {

constexpr std::chrono::milliseconds between_looks(50);
constexpr int most_patience = 3;  // times `patience`, however often the solver gives signs of life

}  // namespace

Watchdog::Watchdog(std::function<bool()> stop, End end, std::chrono::duration<double> patience)
    : stop_(std::move(stop)), end_(std::move(end)), patience_(patience) {
  live();
  thread_ = std::thread([this] { watch(); });
}

Watchdog::~Watchdog() {
  stand_down();
  thread_.join();
}

bool Watchdog::stop() {
  live();
  return stop_();
}

void Watchdog::begin(const std::string& stage) {
  live();
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!ending_) stage_ = stage;
}

void Watchdog::keep(MakeResult state) {
  live();
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!ending_) std::swap(state_, state);  // the old state is freed after the lock
}

void Watchdog::stand_down() {
  std::unique_lock<std::mutex> lock(mutex_);
  while (ending_) wake_.wait(lock);  // until the process ends
  down_ = true;
  wake_.notify_all();
}

void Watchdog::watch() {
  std::unique_lock<std::mutex> lock(mutex_);
  std::optional<Clock::time_point> stopped;
  while (!wake_.wait_for(lock, between_looks, [&] { return down_; })) {
    const Clock::time_point now = Clock::now();
    if (!stopped && stop_()) stopped = now;
    if (!stopped) continue;
    const Clock::time_point alive =
        std::max(*stopped, Clock::time_point(Clock::duration(alive_.load())));
    if (now - alive < patience_ && now - *stopped < most_patience * patience_) continue;
    ending_ = true;
    lock.unlock();
    const int exit_code = end_(state_, stage_);  // both stay as they are from now on
    std::cout.flush();
    std::cerr.flush();
    // Not exit(): the solver's thread still uses what that would destroy.
    _exit(exit_code);
  }
}

}  // namespace vasorod
