#include "python/apart.h"

namespace vasorod::python {
namespace {

namespace py = pybind11;

// Between two looks at signals and progress, s; and for how long after Ctrl-C a job may go on.
constexpr double between_looks = 0.05, last_chance = 0.8;

bool ended_within(Job& job, double seconds) {
  const py::gil_scoped_release others_run;
  return job.ended_within(seconds);
}

// The wait ends although the job has not.
void end_early(const std::shared_ptr<Job>& job, OnInterrupt on_interrupt) {
  const py::gil_scoped_release others_run;
  job->ask_to_stop();
  if (on_interrupt == OnInterrupt::wait_for) {
    while (!job->ended_within(1)) {
    }
  } else if (!job->ended_within(last_chance)) {
    Job::leave(job);
    return;
  }
  try {
    job->finish();
  } catch (...) {  // what ended the wait is raised instead
  }
}

}  // namespace

bool wait_for(const std::shared_ptr<Job>& job, OnInterrupt on_interrupt,
              const py::object& progress) {
  const auto tell = [&] {
    for (const std::string& stage : job->begun())
      if (!progress.is_none()) progress(stage);
  };
  try {
    while (!ended_within(*job, between_looks)) {
      if (PyErr_CheckSignals() != 0) throw py::error_already_set();
      tell();
      if (job->is_overdue()) return false;
    }
    tell();
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
  } catch (...) {
    end_early(job, on_interrupt);
    throw;
  }
  job->finish();
  return true;
}

}  // namespace vasorod::python
