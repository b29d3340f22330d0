#include "reference_fem/newton.h"

#include <algorithm>
#include <cmath>

#include "reference_fem/clock.h"

namespace vasorod::fem {

Newton::Verdict Newton::judge(double r, int iteration) {
  if (iteration == 0) best_ = 1e300;
  if (!std::isfinite(r) || r > 1e6) return Verdict::failed;
  iterations_ = iteration;
  if (r <= options_.tolerance) return Verdict::done;
  // no more progress at a small residual: rounding
  if (r <= options_.loose_tolerance && r > 0.3 * best_ && iteration > 2) return Verdict::done;
  if (iteration > 4 && r > 1e3 * best_) return Verdict::failed;
  best_ = std::min(best_, r);
  return iteration == options_.max_iterations ? Verdict::failed : Verdict::go_on;
}

bool Newton::assemble(const State& state, double load, System::Assembly& assembly) {
  const double start = now();
  system_.assemble(state, load, true, assembly);
  summary_.assembly_seconds += now() - start;
  return assembly.admissible;
}

bool Newton::factor(const System::Assembly& assembly) {
  const double start = now();
  const bool ok = solver_.factor(assembly.tangent, system_.symmetric(), system_.multipliers());
  summary_.factor_seconds += now() - start;
  return ok;
}

bool Newton::at_load(State& state, double load, System::Assembly& assembly) {
  if (!assemble(state, load, assembly)) return false;
  for (int iteration = 0;; ++iteration) {
    const Verdict verdict = judge(assembly.relative_residual(), iteration);
    if (verdict != Verdict::go_on) return verdict == Verdict::done;
    if (!factor(assembly)) return false;
    Eigen::VectorXd step = -solver_.solve(assembly.residual);
    if (!step.allFinite()) return false;
    ++summary_.iterations;
    State trial = state;
    bool inside = false;
    for (int half = 0; half < 6 && !inside; ++half, step *= 0.5) {
      trial = state;
      system_.add(trial, step);
      inside = assemble(trial, load, assembly);
    }
    if (!inside) return false;
    state = std::move(trial);
  }
}

// The residual's derivative with respect to the load, prescribed motions included. A finite
// difference is accurate enough: it affects only the iterations, not the equilibrium.
Eigen::VectorXd Newton::load_slope(const State& state, double load,
                                   const System::Assembly& assembly) {
  constexpr double h = 1e-6;
  State ahead = state;
  system_.prescribe(ahead, load + h);
  System::Assembly moved;
  const double start = now();
  system_.assemble(ahead, load + h, false, moved);
  summary_.assembly_seconds += now() - start;
  if (!moved.admissible) return Eigen::VectorXd::Constant(system_.size(), std::nan(""));
  return (moved.residual - assembly.residual) / h;
}

bool Newton::along(State& state, double& load, const Eigen::VectorXd& direction,
                   System::Assembly& assembly) {
  if (!assemble(state, load, assembly)) return false;
  for (int iteration = 0;; ++iteration) {
    const Verdict verdict = judge(assembly.relative_residual(), iteration);
    if (verdict != Verdict::go_on) return verdict == Verdict::done;
    const Eigen::VectorXd slope = load_slope(state, load, assembly);
    if (!slope.allFinite() || !factor(assembly)) return false;
    const Eigen::VectorXd correct = -solver_.solve(assembly.residual),
                          follow = -solver_.solve(slope);
    double change = -direction.dot(correct) / direction.dot(follow);
    Eigen::VectorXd step = correct + change * follow;
    if (!step.allFinite()) return false;
    ++summary_.iterations;
    State trial = state;
    bool inside = false;
    for (int half = 0; half < 6 && !inside; ++half, step *= 0.5, change *= 0.5) {
      trial = state;
      system_.prescribe(trial, load + change);
      system_.add(trial, step);
      inside = assemble(trial, load + change, assembly);
      if (inside) load += change;
    }
    if (!inside) return false;
    state = std::move(trial);
  }
}

bool Newton::linear_step(const State& last, double load, State& guess, System::Assembly& assembly) {
  State base = last;
  for (std::size_t k = 0; k < base.pose.size(); ++k)
    if (system_.supports().sections[k].soft) base.pose[k] = guess.pose[k];
  const double start = now();
  system_.assemble(base, load, true, assembly, &guess);
  summary_.assembly_seconds += now() - start;
  if (!assembly.admissible || !factor(assembly)) return false;
  const Eigen::VectorXd step = -solver_.solve(assembly.residual);
  if (!step.allFinite()) return false;
  ++summary_.iterations;
  system_.add(guess, step);
  return true;
}

}  // namespace vasorod::fem
