// Runs a computation as a job and waits for it as a Python function should.
#pragma once

#include <functional>
#include <memory>
#include <pybind11/pybind11.h>

#include "python/job.h"

namespace vasorod::python {

/// What to do when Ctrl-C ends the wait.
enum class OnInterrupt {
  leave,    ///< give the computation a second to end, then leave it to itself
  wait_for  ///< ask it to stop and wait until it has ended
};

/// Waits for a job without holding the GIL; called with the GIL held. Calls `progress` with every
/// stage; None: nothing. True: it has ended. False: it goes on long after its time limit. Throws
/// what the job throws, and KeyboardInterrupt or whatever `progress` raises.
bool wait_for(const std::shared_ptr<Job>& job, OnInterrupt on_interrupt,
              const pybind11::object& progress = pybind11::none());

/// The value of a computation that has no time limit.
template <class Value>
std::shared_ptr<Value> apart(std::function<Value(Job&)> work,
                             OnInterrupt on_interrupt = OnInterrupt::leave) {
  auto value = std::make_shared<Value>();
  const auto job = Job::start([value, work = std::move(work)](Job& self) { *value = work(self); });
  wait_for(job, on_interrupt);
  return value;
}

}  // namespace vasorod::python
