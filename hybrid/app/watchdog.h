// Ends the program if the solver does not react to a signal or the time limit: the ordering and the
// factorisation of a large matrix cannot be interrupted.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <string>
#include <thread>

#include <vasorod/result.h>

namespace vasorod {

/// A thread that waits until `stop` is true and then for the solver to react. It ends the process
/// `patience` after the solver's last call of stop(), begin() or keep(), and at the latest three
/// times `patience` after `stop` was true, whatever the solver is doing.
class Watchdog {
 public:
  using MakeResult = std::function<Result()>;
  /// Called on the watchdog's thread with the last state that was kept (empty: none) and the
  /// present stage. Returns the exit code of the process.
  using End = std::function<int(const MakeResult& state, const std::string& stage)>;

  Watchdog(std::function<bool()> stop, End end,
           std::chrono::duration<double> patience = std::chrono::milliseconds(1500));
  /// As stand_down().
  ~Watchdog();
  Watchdog(const Watchdog&) = delete;
  Watchdog& operator=(const Watchdog&) = delete;

  /// `stop` for the solver; each call is a sign of life.
  bool stop();
  /// The stage that begins; a sign of life.
  void begin(const std::string& stage);
  /// The state to write if the solver does not answer.
  void keep(MakeResult state);
  /// The solver has answered: the watchdog does nothing from now on. Does not return where the
  /// watchdog is ending the process already.
  void stand_down();

 private:
  using Clock = std::chrono::steady_clock;
  void watch();
  void live() { alive_ = Clock::now().time_since_epoch().count(); }

  const std::function<bool()> stop_;
  const End end_;
  const std::chrono::duration<double> patience_;
  std::atomic<Clock::rep> alive_{0};  // the last sign of life
  std::mutex mutex_;                  // of all below
  std::condition_variable wake_;
  bool down_ = false, ending_ = false;
  MakeResult state_;
  std::string stage_;
  std::thread thread_;  // declared last, because it uses the others
};

}  // namespace vasorod
