#include "planner/solve_jobs.h"

#include <charconv>
#include <utility>

#include <vasorod/predict.h>

#include "data/sentence.h"
#include "numerics/threads.h"
#include "planner/failure.h"
#include "predict/name_stop.h"
#include "result/sha256.h"

namespace vasorod::planner {
namespace {

constexpr std::size_t most_jobs = 64;  // whose end may still be asked for
// A step that cannot be stopped inside (the ordering of a large matrix) is waited for so long;
// then the state before it is the result.
constexpr std::chrono::milliseconds patience(1500);
// For which the answer to a request to stop waits for the stop.
constexpr std::chrono::milliseconds between(500);

// What stops a solve whose result is wanted: the page's button.
const std::string cancel_button = "Cancel";

// Thrown inside a solve that nobody wants any more, between its stages.
struct Dropped {};

}  // namespace

struct SolveJobs::Job {
  std::string id, fidelity, state = "running", stage = "waiting", error, result;
  std::shared_ptr<const OpenedScene> opened;
  std::optional<Plan> plan;
  Scene scene;
  Clock::time_point begun = Clock::now(), ended, asked_at;
  std::atomic<bool> asked{false}, dropped{false};
  std::function<Result()> kept;
  long changes = 0;

  bool over() const { return state != "running"; }
};

SolveJobs::SolveJobs(ResultShelf& shelf) : shelf_(shelf), thread_([this] { work(); }) {}

SolveJobs::~SolveJobs() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    ending_ = true;
    for (auto& [number, job] : jobs_) job->asked = job->dropped = true;
    wake_.notify_all();
  }
  thread_.join();
}

std::string SolveJobs::begin(std::shared_ptr<const OpenedScene> opened,
                             const std::optional<Plan>& plan, const std::string& fidelity) {
  auto job = std::make_shared<Job>();
  job->scene = plan ? with_plan(*opened, *plan, fidelity) : opened->scene;
  job->opened = std::move(opened);
  job->plan = plan;
  job->fidelity = fidelity;
  const std::lock_guard<std::mutex> lock(mutex_);
  drop_locked();
  const long number = ++count_;
  job->id = "j" + std::to_string(number);
  jobs_[number] = job;
  if (jobs_.size() > most_jobs) jobs_.erase(jobs_.begin());
  next_ = job;
  wake_.notify_all();
  return job->id;
}

void SolveJobs::drop_all() {
  const std::lock_guard<std::mutex> lock(mutex_);
  drop_locked();
}

void SolveJobs::drop_locked() {
  if (next_) next_->opened.reset();
  next_.reset();
  for (auto& [number, job] : jobs_) {
    if (job->over()) continue;
    job->asked = job->dropped = true;
    end(*job, "cancelled");
  }
}

void SolveJobs::end(Job& job, const std::string& state,
                    const std::shared_ptr<const StoredResult>& stored, const std::string& error) {
  if (stored) {
    shelf_.put(stored);
    job.result = stored->id;
  } else {
    job.error = error;
  }
  job.state = state;
  job.ended = Clock::now();
  ++job.changes;
  changed_.notify_all();
}

void SolveJobs::work() {
  while (true) {
    std::shared_ptr<Job> job;
    {
      std::unique_lock<std::mutex> lock(mutex_);
      wake_.wait(lock, [&] { return ending_ || next_; });
      if (ending_) return;
      job = std::exchange(next_, nullptr);
    }
    solve(*job);
  }
}

// What keeping and looking at a result needs beyond it.
std::shared_ptr<const StoredResult> SolveJobs::store(const Job& job, const OpenedScene& opened,
                                                     Result&& result) {
  if (job.plan) {  // the file that this scene would be saved as
    result.environment.scene_hash = sha256_of_text(job.scene.text);
    result.environment.inputs[opened.scene.file.filename().string()] =
        result.environment.scene_hash;
  }
  const std::string json = to_json(result);
  auto stored = std::make_shared<StoredResult>(shelf_.next_id(), std::move(result), job.plan, json);
  for (std::size_t v = 0; v < stored->result.vessels.size(); ++v)
    for (const PreparedVessel& vessel : opened.fitted.vessels)
      if (vessel.spec.name == stored->result.vessels[v].name && vessel.spec.wall)
        stored->to_lumen[v] = vessel.lumen_offset();
  return stored;
}

void SolveJobs::solve(Job& job) {
  std::shared_ptr<const OpenedScene> opened;  // not kept by jobs that have ended
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    opened = job.opened;
  }
  const auto live = [&] {
    if (job.dropped) throw Dropped();
  };
  SolveOptions options;
  options.fidelity = job.fidelity;
  options.patience = 0;
  options.threads = processors();
  options.stop = [&] { return job.asked.load(); };
  options.stopped_by = [] { return cancel_button; };
  options.progress = [&](const std::string& stage) {
    live();
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!job.asked) job.stage = stage;
    ++job.changes;
    changed_.notify_all();
  };
  options.solved = live;
  // Quick fidelities end by themselves before a state of theirs could be wanted.
  if (job.fidelity != "rod" && job.fidelity != "skin")
    options.keep = [&](std::function<Result()> state) {
      const std::lock_guard<std::mutex> lock(mutex_);
      std::swap(job.kept, state);  // the old state is freed after the lock
    };
  std::shared_ptr<const StoredResult> stored;
  std::string error;  // empty: nobody asks for one
  try {
    live();
    Result result = predict(job.scene, options, opened->fitted);
    stored = store(job, *opened, std::move(result));
  } catch (const Dropped&) {
  } catch (const StoppedEarly& stopped) {
    if (!job.asked) error = one_line(stopped.what());
  } catch (...) {
    error = failure_now().sentence;
  }
  std::function<Result()> kept;  // freed after the lock
  const std::lock_guard<std::mutex> lock(mutex_);
  std::swap(job.kept, kept);
  job.opened.reset();
  if (job.over()) return;  // dropped, or ended with a kept state
  end(job, job.asked ? "cancelled" : stored ? "done" : "failed", stored, error);
}

Json SolveJobs::said(Job& job) const {
  const Clock::time_point until = job.over() ? job.ended : Clock::now();
  return {{"id", job.id},
          {"state", job.state},
          {"stage", job.stage},
          {"seconds", std::chrono::duration<double>(until - job.begun).count()},
          {"fidelity", job.fidelity},
          {"error", job.error.empty() ? Json() : Json(job.error)},
          {"result", job.result.empty() ? Json() : Json(job.result)}};
}

std::shared_ptr<SolveJobs::Job> SolveJobs::find(const std::string& id) {
  long number = 0;
  const char* end = id.data() + id.size();
  const bool good =
      id.size() > 1 && id[0] == 'j' && std::from_chars(id.data() + 1, end, number).ptr == end;
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto found = good ? jobs_.find(number) : jobs_.end();
  if (found == jobs_.end())
    throw Refusal(404, "found no job " + in_quotes(id) + ", expected one of the last " +
                           std::to_string(most_jobs));
  return found->second;
}

Json SolveJobs::status(const std::string& id, std::chrono::milliseconds wait) {
  const std::shared_ptr<Job> job = find(id);
  const Clock::time_point until = Clock::now() + wait;
  std::unique_lock<std::mutex> lock(mutex_);
  const long before = job->changes;
  while (!job->over() && job->changes == before && Clock::now() < until) {
    changed_.wait_until(lock, std::min(until, Clock::now() + std::chrono::milliseconds(100)));
    end_if_overdue(*job, lock);
  }
  end_if_overdue(*job, lock);
  return said(*job);
}

Json SolveJobs::cancel(const std::string& id) {
  const std::shared_ptr<Job> job = find(id);
  std::unique_lock<std::mutex> lock(mutex_);
  if (!job->over() && !job->asked) {
    job->asked_at = Clock::now();
    job->asked = true;
    job->stage = "stopping";
    ++job->changes;
    changed_.notify_all();
    if (next_ == job) {  // not begun
      next_.reset();
      job->opened.reset();
      end(*job, "cancelled");
    }
  }
  const Clock::time_point until = Clock::now() + between;
  while (!job->over() && Clock::now() < until) changed_.wait_until(lock, until);
  return said(*job);
}

// A step that cannot be stopped inside goes on; the page has the state before it meanwhile.
void SolveJobs::end_if_overdue(Job& job, std::unique_lock<std::mutex>& lock) {
  if (job.over() || !job.asked || Clock::now() - job.asked_at < patience || !job.kept) return;
  const std::function<Result()> kept = std::exchange(job.kept, nullptr);
  const std::shared_ptr<const OpenedScene> opened = job.opened;
  const std::string stage = job.stage;
  lock.unlock();
  std::shared_ptr<const StoredResult> stored;
  std::string error;
  try {
    Result result = kept();
    name_stop(cancel_button, stage, result);
    stored = store(job, *opened, std::move(result));
  } catch (...) {
    error = failure_now().sentence;
  }
  lock.lock();
  if (!job.over()) end(job, "cancelled", stored, error);
}

}  // namespace vasorod::planner
