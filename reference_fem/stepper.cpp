#include "reference_fem/stepper.h"

#include <algorithm>
#include <cmath>

#include "reference_fem/arc_length.h"
#include "reference_fem/newton.h"

namespace vasorod::fem {
namespace {

/// First guess at `load`: extrapolated from the last states, or one linear step from a single one.
bool predict(const System& system, Newton& newton, const std::vector<PathPoint>& history,
             const State& last, double load, State& guess, System::Assembly& assembly) {
  guess = last;
  system.prescribe(guess, load);
  if (history.size() < 2) return newton.linear_step(last, load, guess, assembly);
  const auto& [t1, d1] = history[history.size() - 2];
  const double t2 = history.back().load, s = load - t2;
  if (history.size() == 2) {
    system.add(guess, s / (t1 - t2) * d1);
  } else {
    const auto& [t0, d0] = history[history.size() - 3];
    const double a = t0 - t2, b = t1 - t2;
    system.add(guess, s * (s - b) / (a * (a - b)) * d0 + s * (s - a) / (b * (b - a)) * d1);
  }
  return true;
}

}  // namespace

std::string to_string(PathStatus status) {
  switch (status) {
    case PathStatus::complete:
      return "complete";
    case PathStatus::stuck:
      return "stuck";
    case PathStatus::interrupted:
      return "interrupted";
  }
  return {};
}

StepperSummary follow_path(const System& system, State& state, System::Assembly& assembly,
                           const StepperOptions& options) {
  StepperSummary summary;
  Newton newton(system, options, summary);
  state = system.rest();
  std::vector<PathPoint> history{{0, Eigen::VectorXd::Zero(system.size())}};
  double step = options.first_step;
  std::size_t next_stop = 0;
  System::Assembly trial_assembly;
  system.assemble(state, 0, false, assembly);
  while (summary.load < 1) {
    if (options.interrupted && options.interrupted()) {
      summary.status = PathStatus::interrupted;
      return summary;
    }
    double stop = 1;
    while (next_stop < options.stops.size() && options.stops[next_stop] <= summary.load + 1e-12)
      ++next_stop;
    if (next_stop < options.stops.size()) stop = std::min(stop, options.stops[next_stop]);
    double load = summary.load + step;
    if (load > stop - 0.3 * step) load = stop;

    State guess, trial;
    bool ok = predict(system, newton, history, state, load, guess, trial_assembly);
    if (ok) {
      trial = guess;
      ok = newton.at_load(trial, load, trial_assembly);
    }
    // If Newton moved further than the step itself, it jumped to another branch or over a limit
    // point.
    if (ok && history.size() == 3)
      ok = system.difference(guess, trial).norm() <=
           options.largest_jump * system.difference(state, trial).norm();
    if (!ok) {
      ++summary.cutbacks;
      step = std::min(step, load - summary.load) / 2;
      if (step >= options.smallest_step) continue;
      if (follow_arc(system, state, assembly, history, options, summary)) break;
      if (summary.status == PathStatus::complete) summary.status = PathStatus::stuck;
      return summary;
    }
    const Eigen::VectorXd moved = system.difference(state, trial);
    append(history, load, moved);
    state = std::move(trial);
    std::swap(assembly, trial_assembly);
    const double taken = load - summary.load;
    summary.load = load;
    summary.relative_residual = assembly.relative_residual();
    summary.energy = assembly.energy;
    ++summary.steps;
    if (options.on_step) options.on_step(load, state, assembly);
    if (newton.iterations() <= 4)
      step = std::max(step, std::min(1.5 * taken, options.largest_step));
    if (newton.iterations() >= 9) step = std::max(taken / 1.5, options.smallest_step);
    step = std::min(step, options.largest_step);
  }
  if (options.certify && system.conservative()) {
    summary.positive_definite = newton.positive_definite(state, assembly);
  }
  return summary;
}

}  // namespace vasorod::fem
