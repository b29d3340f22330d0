// Solves one plan after the other on a thread of its own: the newest wins.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "planner/opened_scene.h"
#include "planner/result_shelf.h"

namespace vasorod::planner {

class SolveJobs {
 public:
  /// Results go to the shelf, which must outlive this.
  explicit SolveJobs(ResultShelf& shelf);
  ~SolveJobs();
  SolveJobs(const SolveJobs&) = delete;
  SolveJobs& operator=(const SolveJobs&) = delete;

  /// Cancels what runs, whose state is then of no interest, and begins. Empty plan: the scene as it
  /// is. Returns the job's id. Throws Refusal for a plan that does not belong to the scene.
  std::string begin(std::shared_ptr<const OpenedScene> opened, const std::optional<Plan>& plan,
                    const std::string& fidelity);

  /// {id, state, stage, seconds, fidelity, error, result}. Waits up to `wait` for a change of stage
  /// or state. Throws Refusal (404).
  Json status(const std::string& id, std::chrono::milliseconds wait);

  /// Asks the job to stop with its best state, waits a little, and says its status.
  Json cancel(const std::string& id);

  /// Cancels whatever runs; its state is of no interest.
  void drop_all();

 private:
  using Clock = std::chrono::steady_clock;
  struct Job;

  void work();
  void drop_locked();  // as drop_all(), by who holds the lock
  // By who holds the lock: the job is over, with a result, an error or neither.
  void end(Job& job, const std::string& state,
           const std::shared_ptr<const StoredResult>& stored = {}, const std::string& error = {});
  void solve(Job& job);
  std::shared_ptr<const StoredResult> store(const Job& job, const OpenedScene& opened,
                                            Result&& result);
  std::shared_ptr<Job> find(const std::string& id);
  Json said(Job& job) const;
  void end_if_overdue(Job& job, std::unique_lock<std::mutex>& lock);

  ResultShelf& shelf_;
  std::mutex mutex_;  // of all below and of the jobs
  std::condition_variable wake_, changed_;
  std::map<long, std::shared_ptr<Job>> jobs_;  // the last ones, by number
  std::shared_ptr<Job> next_;
  long count_ = 0;
  bool ending_ = false;
  std::thread thread_;
};

}  // namespace vasorod::planner
