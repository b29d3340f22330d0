#include "reference_fem/stepper.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace vasorod::fem {
namespace {

double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

class Path {
 public:
  Path(const System& system, const StepperOptions& options) : system_(system), options_(options) {}

  /// Newton at `load` from `state` (prescribed values already in place). False: `state` is not to be used.
  bool newton(State& state, double load, System::Assembly& assembly, StepperSummary& summary) {
    double best = 1e300;
    if (!assemble(state, load, assembly, summary)) return false;
    for (int iteration = 0; iteration <= options_.max_iterations; ++iteration) {
      const double r = assembly.relative_residual();
      if (!std::isfinite(r) || r > 1e6) return false;
      iterations_ = iteration;
      if (r <= options_.tolerance) return true;
      // no more progress at a small residual: rounding
      if (r <= options_.loose_tolerance && r > 0.3 * best && iteration > 2) return true;
      if (iteration > 4 && r > 1e3 * best) return false;
      best = std::min(best, r);
      if (iteration == options_.max_iterations) return false;
      if (!factor(assembly, summary)) return false;
      Eigen::VectorXd step = -solver_.solve(assembly.residual);
      if (!step.allFinite()) return false;
      ++summary.iterations;
      State trial = state;
      bool inside = false;
      for (int half = 0; half < 6 && !inside; ++half, step *= 0.5) {
        trial = state;
        system_.add(trial, step);
        inside = assemble(trial, load, assembly, summary);
      }
      if (!inside) return false;
      state = std::move(trial);
    }
    return false;
  }

  /// First guess at `load`: extrapolated through the last states, or one linear step from the only one.
  bool predict(const State& last, double load, State& guess, System::Assembly& assembly,
               StepperSummary& summary) {
    guess = last;
    system_.prescribe(guess, load);
    if (history_.size() >= 2) {
      const auto& [t1, d1] = history_[history_.size() - 2];  // earlier states relative to the last
      const double t2 = history_.back().first, s = load - t2;
      if (history_.size() == 2) {
        system_.add(guess, s / (t1 - t2) * d1);
      } else {
        const auto& [t0, d0] = history_[history_.size() - 3];
        const double a = t0 - t2, b = t1 - t2;
        system_.add(guess, s * (s - b) / (a * (a - b)) * d0 + s * (s - a) / (b * (b - a)) * d1);
      }
      return true;
    }
    State base = last;
    for (std::size_t k = 0; k < base.pose.size(); ++k)
      if (system_.supports().sections[k].soft) base.pose[k] = guess.pose[k];
    const double start = now();
    system_.assemble(base, load, true, assembly, &guess);
    summary.assembly_seconds += now() - start;
    if (!assembly.admissible || !factor(assembly, summary)) return false;
    const Eigen::VectorXd step = -solver_.solve(assembly.residual);
    if (!step.allFinite()) return false;
    ++summary.iterations;
    system_.add(guess, step);
    return true;
  }

  void remember(double load, const State& from, const State& to) {
    // keep earlier states as differences to the newest
    const Eigen::VectorXd shift = system_.difference(to, from);
    for (auto& [t, d] : history_) d = d + shift;
    history_.emplace_back(load, Eigen::VectorXd::Zero(system_.size()));
    if (history_.size() > 3) history_.erase(history_.begin());
  }
  void forget() { history_.clear(); }
  int iterations() const { return iterations_; }

  bool factor(const System::Assembly& assembly, StepperSummary& summary) {
    const double start = now();
    const bool ok = solver_.factor(assembly.tangent, system_.symmetric(), system_.multipliers());
    summary.factor_seconds += now() - start;
    return ok;
  }

 private:
  bool assemble(const State& state, double load, System::Assembly& assembly, StepperSummary& summary) {
    const double start = now();
    system_.assemble(state, load, true, assembly);
    summary.assembly_seconds += now() - start;
    return assembly.admissible;
  }

  const System& system_;
  const StepperOptions& options_;
  LinearSolver solver_;
  std::vector<std::pair<double, Eigen::VectorXd>> history_;
  int iterations_ = 0;
};

}  // namespace

std::string to_string(PathStatus status) {
  switch (status) {
    case PathStatus::complete:
      return "complete";
    case PathStatus::stuck:
      return "stuck";
    case PathStatus::singular:
      return "singular";
    case PathStatus::interrupted:
      return "interrupted";
  }
  return {};
}

StepperSummary follow_path(const System& system, State& state, System::Assembly& assembly,
                           const StepperOptions& options) {
  StepperSummary summary;
  Path path(system, options);
  state = system.rest();
  path.remember(0, state, state);
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
    while (next_stop < options.stops.size() && options.stops[next_stop] <= summary.load + 1e-12) ++next_stop;
    if (next_stop < options.stops.size()) stop = std::min(stop, options.stops[next_stop]);
    double load = summary.load + step;
    if (load > stop - 0.3 * step) load = stop;

    State trial;
    bool ok = path.predict(state, load, trial, trial_assembly, summary) &&
              path.newton(trial, load, trial_assembly, summary);
    if (!ok) {
      ++summary.cutbacks;
      step = std::min(step, load - summary.load) / 2;
      if (step < options.smallest_step) {
        summary.status = PathStatus::stuck;
        return summary;
      }
      continue;
    }
    path.remember(load, state, trial);
    state = std::move(trial);
    std::swap(assembly, trial_assembly);
    const double taken = load - summary.load;
    summary.load = load;
    summary.relative_residual = assembly.relative_residual();
    summary.energy = assembly.energy;
    ++summary.steps;
    if (options.on_step) options.on_step(load, state, assembly);
    if (path.iterations() <= 4) step = std::max(step, std::min(1.5 * taken, options.largest_step));
    if (path.iterations() >= 9) step = std::max(taken / 1.5, options.smallest_step);
    step = std::min(step, options.largest_step);
  }
  if (options.certify && system.conservative()) {
    system.assemble(state, 1, true, assembly);
    LinearSolver solver;
    solver.factor(Sparse(0.5 * (assembly.tangent + Sparse(assembly.tangent.transpose()))), true,
                  system.multipliers(), LinearSolver::Fallback::none);
    summary.positive_definite = solver.positive_definite();
  }
  return summary;
}

}  // namespace vasorod::fem
