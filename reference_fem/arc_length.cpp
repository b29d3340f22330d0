#include "reference_fem/arc_length.h"

#include <algorithm>
#include <cmath>

namespace vasorod::fem {
namespace {

/// Norm of displacements and poses. The multipliers of soft sections are forces and do not count.
double length(const System& system, const Eigen::VectorXd& unknowns) {
  return unknowns.head(system.size() - system.multipliers()).norm();
}

/// Quadratic (with two points linear) extrapolation of the path by the arc length `step` from its
/// newest point, the last of `history`.
struct Guess {
  double load = 0;
  Eigen::VectorXd unknowns;  ///< from the newest point
};

Guess extrapolate(const System& system, const std::vector<PathPoint>& history, double step) {
  const PathPoint &last = history.back(), &before = history[history.size() - 2];
  const double b = -length(system, before.from_last);
  if (history.size() == 2)
    return {last.load + step / b * (before.load - last.load), step / b * before.from_last};
  const PathPoint& first = history[history.size() - 3];
  const double a = b - length(system, first.from_last - before.from_last);
  const double wa = step * (step - b) / (a * (a - b)), wb = step * (step - a) / (b * (b - a));
  return {last.load + wa * (first.load - last.load) + wb * (before.load - last.load),
          wa * first.from_last + wb * before.from_last};
}

}  // namespace

void append(std::vector<PathPoint>& history, double load, const Eigen::VectorXd& moved) {
  for (PathPoint& point : history) point.from_last -= moved;
  history.push_back({load, Eigen::VectorXd::Zero(moved.size())});
  if (history.size() > 3) history.erase(history.begin());
}

bool follow_arc(const System& system, State& state, System::Assembly& assembly,
                std::vector<PathPoint> history, const StepperOptions& options,
                StepperSummary& summary) {
  if (history.size() < 2) return false;
  Newton newton(system, options, summary);
  State best = state, now = state;
  System::Assembly best_assembly = assembly, trial_assembly;
  double load = summary.load, best_load = load, best_energy = summary.energy,
         best_residual = summary.relative_residual;
  double step = length(system, history[history.size() - 2].from_last);
  const double start_step = step, smallest = 1e-4 * step;
  double direction = 1;  // of the load
  const auto settle_for_best = [&](bool arrived) {
    state = best;
    assembly = best_assembly;
    summary.load = best_load;
    summary.energy = best_energy;
    summary.relative_residual = best_residual;
    return arrived;
  };
  for (int k = 0; k < options.arc_steps;) {
    if (options.interrupted && options.interrupted()) {
      summary.status = PathStatus::interrupted;
      return settle_for_best(false);
    }
    Guess guess = extrapolate(system, history, step);
    // the load may change by at most the largest load step
    while (std::abs(guess.load - load) > options.largest_step && step > smallest) {
      step *= 0.5;
      guess = extrapolate(system, history, step);
    }
    State trial = now;
    double trial_load = guess.load;
    const bool arrives = guess.load >= 1;
    if (arrives) {
      const double share = (1 - load) / (guess.load - load);
      guess.unknowns *= share;
      trial_load = 1;
    }
    system.prescribe(trial, trial_load);
    system.add(trial, guess.unknowns);
    Eigen::VectorXd unit = guess.unknowns;
    unit.tail(system.multipliers()).setZero();
    unit.normalize();
    bool ok = arrives ? newton.at_load(trial, 1, trial_assembly)
                      : newton.along(trial, trial_load, unit, trial_assembly);
    Eigen::VectorXd moved;
    if (ok) {  // neither back along the path nor far from the expected point
      moved = system.difference(now, trial);
      ok = moved.dot(unit) > 0.7 * length(system, moved);
    }
    if (!ok) {
      ++summary.cutbacks;
      step *= 0.5;
      if (step < smallest) return settle_for_best(false);
      continue;
    }
    ++k;
    ++summary.steps;
    if ((trial_load - load) * direction < 0) {
      if (direction > 0) summary.limit_loads.push_back(load);
      direction = -direction;
    }
    append(history, trial_load, moved);
    now = std::move(trial);
    load = trial_load;
    if (options.on_step) options.on_step(load, now, trial_assembly);
    if (load > best_load || arrives) {
      best = now;
      best_assembly = trial_assembly;
      best_load = load;
      best_energy = trial_assembly.energy;
      best_residual = trial_assembly.relative_residual();
    }
    if (arrives) return settle_for_best(true);
    if (load < -1)
      return settle_for_best(
          false);  // a deep snap may need the load reversed, but not beyond its size
    if (newton.iterations() <= 4) step = std::min(1.5 * step, 30 * start_step);
    if (newton.iterations() >= 9) step /= 1.5;
  }
  return settle_for_best(false);
}

}  // namespace vasorod::fem
