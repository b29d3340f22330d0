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

bool Newton::assemble(const State& state, double load, bool want_tangent,
                      System::Assembly& assembly, const State* target) {
  const double start = now();
  system_.assemble(state, load, want_tangent, assembly, target);
  summary_.assembly_seconds += now() - start;
  ++summary_.counts.gradients;
  summary_.counts.hessians += want_tangent ? 1 : 0;
  return assembly.admissible;
}

bool Newton::factor(const System::Assembly& assembly) {
  return factor(solver_, assembly.tangent, system_.symmetric());
}

bool Newton::factor(LinearSolver& solver, const Sparse& matrix, bool symmetric,
                    LinearSolver::Fallback fallback) {
  const double start = now();
  const bool ok = solver.factor(matrix, symmetric, system_.multipliers(), fallback);
  summary_.factor_seconds += now() - start;
  Counts& counts = summary_.counts;
  ++counts.factorisations;
  if (ok)
    counts.factor_nonzeros =
        std::max(counts.factor_nonzeros, static_cast<std::int64_t>(solver.factor_nonzeros()));
  return ok;
}

Eigen::VectorXd Newton::solve(const Eigen::VectorXd& right) {
  ++summary_.counts.solves;
  return solver_.solve(right);
}

bool Newton::at_load(State& state, double load, System::Assembly& assembly) {
  if (!assemble(state, load, true, assembly)) return false;
  for (int iteration = 0;; ++iteration) {
    const Verdict verdict = judge(assembly.relative_residual(), iteration);
    if (verdict != Verdict::go_on) return verdict == Verdict::done;
    if (!factor(assembly)) return false;
    Eigen::VectorXd step = -solve(assembly.residual);
    if (!step.allFinite()) return false;
    ++summary_.iterations;
    State trial = state;
    bool inside = false;
    for (int half = 0; half < 6 && !inside; ++half, step *= 0.5) {
      trial = state;
      system_.add(trial, step);
      inside = assemble(trial, load, true, assembly);
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
  if (!assemble(ahead, load + h, false, moved))
    return Eigen::VectorXd::Constant(system_.size(), std::nan(""));
  return (moved.residual - assembly.residual) / h;
}

bool Newton::along(State& state, double& load, const Eigen::VectorXd& direction,
                   System::Assembly& assembly) {
  if (!assemble(state, load, true, assembly)) return false;
  for (int iteration = 0;; ++iteration) {
    const Verdict verdict = judge(assembly.relative_residual(), iteration);
    if (verdict != Verdict::go_on) return verdict == Verdict::done;
    const Eigen::VectorXd slope = load_slope(state, load, assembly);
    if (!slope.allFinite() || !factor(assembly)) return false;
    const Eigen::VectorXd correct = -solve(assembly.residual), follow = -solve(slope);
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
      inside = assemble(trial, load + change, true, assembly);
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
  if (!assemble(base, load, true, assembly, &guess) || !factor(assembly)) return false;
  const Eigen::VectorXd step = -solve(assembly.residual);
  if (!step.allFinite()) return false;
  ++summary_.iterations;
  system_.add(guess, step);
  return true;
}

bool Newton::positive_definite(const State& state, System::Assembly& assembly) {
  assemble(state, 1, true, assembly);
  LinearSolver solver(system_.processes());
  factor(solver, Sparse(0.5 * (assembly.tangent + Sparse(assembly.tangent.transpose()))), true,
         LinearSolver::Fallback::none);
  return solver.positive_definite();
}

}  // namespace vasorod::fem
