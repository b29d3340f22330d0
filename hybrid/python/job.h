// A computation on a thread of its own, so that Python goes on meanwhile: other Python threads run,
// and Ctrl-C is heard at once, also during a step that cannot be stopped inside.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include <vasorod/result.h>

namespace vasorod::python {

/// What a computation shares with the thread that waits for it.
class Job {
 public:
  using MakeResult = std::function<Result()>;
  using Clock = std::chrono::steady_clock;

  /// Starts `work` on a thread. `limit`: seconds from now on after which it should end; empty:
  /// none.
  static std::shared_ptr<Job> start(std::function<void(Job&)> work,
                                    std::optional<double> limit = {});

  // For the computation. Each call is a sign of life.

  bool stop();                           ///< whether it should end with its best state
  void begin(const std::string& stage);  ///< what it does next, in words
  void keep(MakeResult state);           ///< its state so far
  void solved();                         ///< only putting the result together is left

  // For the thread that waits.

  /// Waits so long, seconds; whether the computation has ended.
  bool ended_within(double seconds);
  /// What was begun since the last call.
  std::vector<std::string> begun();
  /// Whether it goes on long after its time limit: it is in a step that cannot be stopped inside.
  bool is_overdue();
  /// The state so far and the stage since then.
  std::pair<MakeResult, std::string> kept();
  void ask_to_stop() { asked_ = true; }
  /// After its end: throws what the computation threw.
  void finish();
  /// Leaves the computation to itself. It ends at the next question whether it should.
  static void leave(std::shared_ptr<Job> job);
  /// Before the interpreter ends: waits for the computations that were left to themselves.
  static void wait_for_left();

 private:
  void run(std::function<void(Job&)> work);
  void live() { alive_ = Clock::now().time_since_epoch().count(); }
  bool past_limit() const { return limit_ && Clock::now() > *limit_; }

  std::optional<Clock::time_point> limit_;
  std::atomic<bool> asked_{false}, solved_{false};
  std::atomic<Clock::rep> alive_{0};

  std::mutex mutex_;  // of what follows
  std::condition_variable wake_;
  bool ended_ = false;
  std::exception_ptr error_;
  std::string stage_;
  std::vector<std::string> begun_;
  MakeResult state_;

  std::thread thread_;
};

}  // namespace vasorod::python
