#include "rod/iteration.h"

#include <algorithm>
#include <cmath>

#include "rod/certificate.h"
#include "rod/symmetry.h"

namespace vasorod {
RodIteration::RodIteration(RodProblem& problem, const RodOptions& options, RodSummary& summary,
                           const StopCheck& stop)
    : problem_(problem), options_(options), summary_(summary), stop_(stop) {}

void RodIteration::count() {
  ++summary_.iterations;
  if (stop_({0, summary_.iterations, summary_.residual})) throw Interrupted{};
}

/// Returns the fraction of the step that decreases the energy sufficiently, 0 if there is none. The
/// moved state is stored in trial_.
double RodIteration::search() {
  const double energy = problem_.potential(state, state), descent = problem_.slope(state, step_);
  if (!(descent < 0) || !std::isfinite(step_.size())) return 0;
  double fraction = 1;
  for (int i = 0; i < 25; ++i) {
    problem_.take(state, step_, fraction, trial_);
    const double change = problem_.potential(trial_, state) - energy;
    if (change <= 1e-4 * fraction * descent + 1e-14 * std::abs(energy)) return fraction;
    // minimum of the parabola through both values and the slope
    const double bend = change - fraction * descent;
    const double best = bend > 0 ? -descent * fraction * fraction / (2 * bend) : 0;
    fraction = std::clamp(best, 0.1 * fraction, 0.5 * fraction);
  }
  return 0;
}

bool RodIteration::newton() {
  problem_.elimination().set_gauge(gauge_springs(problem_, state));
  for (int i = 0; i < options_.max_iterations; ++i) {
    count();
    const double began = stop_.seconds();
    problem_.update_carried(state, false);
    problem_.elimination().factor(state.poses, state.strain, state.stress);
    problem_.elimination().solve(step_.twist, step_.stress, step_.stretch);
    double size = step_.size(), fraction = 1;
    if (problem_.searchable() && size > 0.3) {
      fraction = search();
      if (fraction < 0.05) {  // not a descent direction: replace the step
        double shift = 0;
        step_down(shift);
        size = step_.size();
        fraction = search();
      }
      if (fraction == 0) return false;
    } else if (!(size < 1e3)) {
      return false;
    } else {
      problem_.take(state, step_, 1, trial_);
    }
    if (fraction == 1) {
      trial_.stress.swap(step_.stress);
    } else {
      trial_.stress.resize(state.stress.size());
      for (std::size_t k = 0; k < state.stress.size(); ++k)
        trial_.stress[k] = state.stress[k] + fraction * (step_.stress[k] - state.stress[k]);
    }
    if (whole_ && hard_ && size < best_size_) {
      std::swap(best_, state);
      best_size_ = size;
    }
    std::swap(state, trial_);
    summary_.sweep_seconds += stop_.seconds() - began;
    summary_.last_step = size;
    if (size < options_.tolerance) {
      best_size_ = std::numeric_limits<double>::infinity();  // `state` is better than all before
      return true;
    }
  }
  return false;
}

/// A descent step: the Hessian is shifted until it is positive definite. `shift` is kept for the
/// next step.
void RodIteration::step_down(double& shift) {
  RodElimination& elimination = problem_.elimination();
  elimination.factor(state.poses, state.strain, state.stress, Purpose::descent, shift);
  while (elimination.negative_directions() > 0 && shift < 1e12) {
    shift = std::max(1., 4 * shift);
    elimination.factor(state.poses, state.strain, state.stress, Purpose::descent, shift);
  }
  elimination.solve(step_.twist, step_.stress, step_.stretch);
}

bool RodIteration::descend(double cap, double tolerance, int kicks) {
  problem_.soften(cap);
  problem_.take_elastic_stress(state);
  bool calm = false;
  double shift = 0;
  for (int i = 0; i < 3 * options_.max_iterations && !calm; ++i) {
    count();
    problem_.update_carried(state, false);
    step_down(shift);
    const double size = step_.size();
    if (!std::isfinite(size)) break;
    if (shift > 0 && size < tolerance && kicks > 0) {
      // zero gradient, but not a minimum: continue along the lowest mode
      --kicks;
      if (!kick()) break;
      continue;
    }
    const double energy = problem_.potential(state, state);
    double fraction = std::min(1., 1.5 / size);
    bool accepted = false;
    for (int half = 0; half < 30 && !accepted; ++half, fraction /= 2) {
      problem_.take(state, step_, fraction, trial_);
      // near the minimum the decrease is lost in round-off, and a full step is accepted
      const double e = problem_.potential(trial_, state);
      accepted = e < energy || (fraction == 1 && e <= energy + 1e-10 * std::abs(energy));
      if (accepted) {
        std::swap(state, trial_);
        problem_.take_elastic_stress(state);
        calm = fraction == 1 && size < tolerance;
        shift = fraction == 1 ? (shift > 0.1 ? shift / 4 : 0) : std::max(1., 2 * shift);
      }
    }
    if (!accepted) break;
  }
  problem_.harden();
  return calm;
}

/// Moves along the lowest mode to the side of lower energy, by the largest tried amplitude at which
/// the energy falls. False: there is none.
bool RodIteration::kick() {
  const RodStep mode = lowest_mode(problem_, state);
  const double energy = problem_.potential(state, state), size = mode.size();
  for (double amplitude = 0.3; amplitude > 1e-6; amplitude /= 3) {
    RodState sides[2];
    double change[2] = {};
    for (const int side : {0, 1}) {
      problem_.take(state, mode, (side == 0 ? amplitude : -amplitude) / size, sides[side]);
      change[side] = problem_.potential(sides[side], state) - energy;
    }
    const int lower = change[1] < change[0] ? 1 : 0;
    if (!(change[lower] < 0)) continue;
    std::swap(state, sides[lower]);
    problem_.take_elastic_stress(state);
    return true;
  }
  return false;
}

bool RodIteration::soft_start() {
  descend(100, 1e-2);
  const RodState soft = state;
  if (newton()) return true;
  state = soft;
  const double stiffest = problem_.stiffness_ratio();
  for (double cap = 100; cap < stiffest; cap *= 10) {
    const RodState reached = state;
    problem_.soften(cap);
    hard_ = false;
    const bool ok = newton();
    hard_ = true;
    problem_.harden();
    if (ok) continue;
    state = reached;
    descend(cap, 1e-2);
  }
  return newton();
}

bool RodIteration::minimize() {
  const double stiffest = problem_.stiffness_ratio();
  for (double cap = 1e4; cap < 1e7; cap *= 100) {
    descend(cap, 1e-3, 5);
    if (cap > stiffest) break;
  }
  return newton();
}

void RodIteration::take_best() {
  if (std::isfinite(best_size_)) state = best_;
}

}  // namespace vasorod
