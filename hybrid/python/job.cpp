#include "python/job.h"

#include <algorithm>
#include <utility>

// Declared here as in numerics/blas.cpp.
extern "C" {
int openblas_get_num_threads(void);
void openblas_set_num_threads(int);
}

namespace vasorod::python {
namespace {

// Seconds after the limit, or after the last sign of life, for which a step that cannot be stopped
// inside is waited for, and how many of these at most: as the program does (app/watchdog.h).
constexpr double patience = 1.5, most_patience = 3 * patience;

// NumPy may use the same OpenBLAS. The jobs' number of threads is taken back when the last of them
// has ended; each begins with one thread, whatever ran before.
class BlasThreads {
 public:
  void enter() {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (running_++ > 0) return;
    before_ = openblas_get_num_threads();
    openblas_set_num_threads(1);
  }
  void leave() {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (--running_ == 0) openblas_set_num_threads(before_);
  }

 private:
  std::mutex mutex_;
  int running_ = 0, before_ = 1;
} blas_threads;

// Those that were left to themselves.
std::mutex left_mutex;
std::vector<std::shared_ptr<Job>>& left() {
  static auto* jobs = new std::vector<std::shared_ptr<Job>>;  // lives until the process ends
  return *jobs;
}

double seconds_since(Job::Clock::time_point then) {
  return std::chrono::duration<double>(Job::Clock::now() - then).count();
}

}  // namespace

std::shared_ptr<Job> Job::start(std::function<void(Job&)> work, std::optional<double> limit) {
  auto job = std::make_shared<Job>();
  if (limit)
    job->limit_ = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                     std::chrono::duration<double>(*limit));
  job->live();
  job->thread_ =
      std::thread([job, work = std::move(work)]() mutable { job->run(std::move(work)); });
  return job;
}

void Job::run(std::function<void(Job&)> work) {
  std::exception_ptr error;
  blas_threads.enter();
  try {
    work(*this);
  } catch (...) {
    error = std::current_exception();
  }
  blas_threads.leave();
  work = {};  // what it holds is freed here, not by whoever waits
  const std::lock_guard<std::mutex> lock(mutex_);
  state_ = {};
  error_ = error;
  ended_ = true;
  wake_.notify_all();
}

bool Job::stop() {
  live();
  return asked_ || past_limit();
}

void Job::begin(const std::string& stage) {
  live();
  const std::lock_guard<std::mutex> lock(mutex_);
  stage_ = stage;
  begun_.push_back(stage);
}

void Job::keep(MakeResult state) {
  live();
  const std::lock_guard<std::mutex> lock(mutex_);
  std::swap(state_, state);  // the old state is freed after the lock
}

void Job::solved() {
  solved_ = true;
}

bool Job::ended_within(double seconds) {
  std::unique_lock<std::mutex> lock(mutex_);
  return wake_.wait_for(lock, std::chrono::duration<double>(seconds), [&] { return ended_; });
}

std::vector<std::string> Job::begun() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return std::exchange(begun_, {});
}

bool Job::is_overdue() {
  if (solved_ || !past_limit()) return false;
  const Clock::time_point alive = Clock::time_point(Clock::duration(alive_.load()));
  return seconds_since(std::max(*limit_, alive)) > patience ||
         seconds_since(*limit_) > most_patience;
}

std::pair<Job::MakeResult, std::string> Job::kept() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return {state_, stage_};
}

void Job::finish() {
  thread_.join();
  if (error_) std::rethrow_exception(error_);
}

void Job::leave(std::shared_ptr<Job> job) {
  job->ask_to_stop();
  const std::lock_guard<std::mutex> lock(left_mutex);
  // Those that have ended in the meantime are forgotten.
  std::erase_if(left(), [](const std::shared_ptr<Job>& old) {
    if (!old->ended_within(0)) return false;
    old->thread_.join();
    return true;
  });
  left().push_back(std::move(job));
}

void Job::wait_for_left() {
  const std::lock_guard<std::mutex> lock(left_mutex);
  for (const auto& job : left()) job->thread_.join();
  left().clear();
}

}  // namespace vasorod::python
