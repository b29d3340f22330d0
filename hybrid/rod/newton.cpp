#include "rod/newton.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include <vasorod/error.h>

#include "data/sentence.h"
#include "geometry/rigid_motion.h"
#include "rod/certificate.h"
#include "rod/iteration.h"
#include "rod/rod_solution.h"
#include "rod/start_shape.h"

namespace vasorod {
namespace {

/// The sequence of solution attempts.
class Solver {
 public:
  Solver(const RodTree& tree, const RodConditions& conditions, const RodOptions& options,
         const StopCheck& stop)
      : problem_(tree, conditions),
        options_(options),
        iteration_(problem_, options, summary_, stop) {}
  RodSolution solve(const RodPoses* start);

 private:
  void turn_along(const std::vector<Vec3>& turn);
  bool jump(const RodPoses* start, bool moved);
  void begin_at(const RodPoses* start);
  bool follow_path(int steps);
  RodCertificate leave_saddle(RodCertificate at);
  void note_twist(const RodState& before);
  void judge();
  std::string sharpest_turn() const;

  RodProblem problem_;
  const RodOptions& options_;
  RodSummary summary_;
  RodIteration iteration_;
  std::string left_;  // a sentence on twist that was lost with a saddle; empty: none
};

// Sum of the elements' turns about their axes, radians.
double total_twist(const RodState& state) {
  double twist = 0;
  for (const Vec6& strain : state.strain) twist += std::abs(strain[5]);
  return twist;
}

void Solver::turn_along(const std::vector<Vec3>& turn) {
  RodState& state = iteration_.state;
  double largest = 0;
  state.poses = start_shape(problem_.links(), problem_.conditions(), turn, state.poses, &largest);
  if (largest >= std::numbers::pi)
    throw InputError("rod: the prescribed motions turn one element by " +
                     std::to_string(largest * 180 / std::numbers::pi) +
                     " degrees, expected below 180: use more elements");
  problem_.measure_strains(state);
}

/// Jumps directly to the end of the path.
bool Solver::jump(const RodPoses* start, bool moved) {
  if (!moved) {
    if (iteration_.newton()) return true;
    begin_at(start);
  }
  return iteration_.soft_start();
}

/// Starts from the given poses with the stress of a softened rod, or from the drawn poses without
/// stress.
void Solver::begin_at(const RodPoses* start) {
  iteration_.state = problem_.state_at(start ? *start : problem_.tree().rest);
  if (!start) return;
  problem_.soften(100);
  problem_.take_elastic_stress(iteration_.state);
  problem_.harden();
}

/// Follows the path in steps; a failed step is halved.
bool Solver::follow_path(int steps) {
  double t = 0, dt = 1. / steps;
  // no step turns a support by more than a third of a turn, so that rotations follow the prescribed
  // direction
  for (const RodSupport& s : problem_.given().supports)
    dt = std::min(dt, 2 / std::max(2., s.motion.rotate.norm()));
  RodState reached = iteration_.state;
  while (t < 1) {
    const double next = t + dt > 1 - 1e-9 ? 1 : t + dt;
    problem_.set_time(next);
    iteration_.count_for_best(next == 1);
    bool ok = false;
    for (const bool soft : {false, true}) {
      iteration_.state = reached;
      std::vector<Vec3> turn;
      for (const NodeCondition& c : problem_.conditions())
        turn.push_back(c.supported()
                           ? log_rotation(c.target.rotation *
                                          reached.poses[index(c.node)].rotation.transpose())
                           : Vec3::Zero());
      turn_along(turn);
      ok = soft ? iteration_.soft_start() : iteration_.newton();
      if (ok) break;
    }
    if (!ok) {
      dt /= 2;
      if (dt < 1e-3) {
        iteration_.state = reached;
        summary_.message = "the path could be followed only to " + std::to_string(100 * t) +
                           " % of it" + sharpest_turn();
        return false;
      }
      continue;
    }
    if (options_.leave_saddle && problem_.has_energy()) {
      const RodCertificate at = certify(problem_, iteration_.state);
      if (at.negative > 0) leave_saddle(at);
    }
    reached = iteration_.state;
    t = next;
  }
  return true;
}

/// Descends along the lowest mode in both directions and keeps the lower end state. Repeats as long
/// as that state is a saddle again.
RodCertificate Solver::leave_saddle(RodCertificate at) {
  const RodState first = iteration_.state;
  for (int round = 0; round < 8 && at.negative > 0; ++round) {
    const RodState saddle = iteration_.state;
    const RodStep mode = lowest_mode(problem_, saddle);
    RodState best;
    double lowest = 0;  // change of the potential
    for (const double sign : {1., -1.}) {
      problem_.take(saddle, mode, sign * 0.3 / mode.size(), iteration_.state);
      problem_.take_elastic_stress(iteration_.state);
      const bool found = problem_.searchable() ? iteration_.newton() : iteration_.minimize();
      if (!found) continue;
      const double before = problem_.potential(saddle, saddle),
                   change = problem_.potential(iteration_.state, saddle) - before;
      if (change < lowest - 1e-12 * std::abs(before)) {
        lowest = change;
        best = iteration_.state;
      }
    }
    iteration_.state = best.poses.empty() ? saddle : best;
    at = certify(problem_, iteration_.state);
    if (best.poses.empty()) break;
  }
  note_twist(first);
  return at;
}

/// A rod feels no contact with itself: where it leaves its branch it may pass through itself and
/// lose two turns of twist at a time, or take them up in coils.
void Solver::note_twist(const RodState& before) {
  const double from = total_twist(before), to = total_twist(iteration_.state);
  if (std::abs(from - to) < std::numbers::pi) return;
  const auto degrees = [](double angle) { return number_text(angle * 180 / std::numbers::pi, 4); };
  left_ = "the twisted branch from rest lost its stability, and the twist went from " +
          degrees(from) + " to " + degrees(to) +
          " degrees: turns are lost or taken up by coils, as a rod may pass through itself";
}

/// A sentence on the largest turn of an element. If no minimum is found, the mesh is often too
/// coarse: the strain of an element is one logarithm, limited to less than half a turn.
std::string Solver::sharpest_turn() const {
  double turn = 0;
  for (const Vec6& strain : iteration_.state.strain) turn = std::max(turn, strain.tail<3>().norm());
  if (turn < 1.2) return "";
  return "; an element turns by " + number_text(std::floor(turn * 180 / std::numbers::pi)) +
         " degrees there, use more elements";
}

void Solver::judge() {
  RodCertificate at = certify(problem_, iteration_.state);
  const bool energy = problem_.has_energy();
  if (at.negative > 0 && options_.leave_saddle && energy) at = leave_saddle(at);
  summary_.negative_directions = at.negative;
  summary_.neutral_directions = at.neutral;
  if (!energy) {
    summary_.status = Status::equilibrium_only;
    summary_.message =
        "a moment on a freely turning end has no energy, so no minimum can be certified";
  } else if (at.negative > 0) {
    summary_.status = Status::unstable;
    summary_.message = "the equilibrium is not a minimum: its Hessian has " +
                       std::to_string(at.negative) + " negative direction(s)" + sharpest_turn();
  } else if (!at.minimum()) {
    summary_.status = Status::equilibrium_only;
    summary_.message = "a direction costs nothing, so the minimum is not a strict one";
  } else {
    summary_.status = left_.empty() ? Status::converged : Status::buckled;
    summary_.message = left_;
    if (at.neutral > 0)
      summary_.message +=
          (left_.empty() ? "" : "; ") +
          ("the minimum is one of a family, because " + at.symmetry + " costs nothing");
  }
}

RodSolution Solver::solve(const RodPoses* start) {
  RodState& state = iteration_.state;
  begin_at(start);
  bool moved = false;
  const std::vector<NodeCondition>& conditions = problem_.conditions();
  std::vector<Vec3> turn(conditions.size(), Vec3::Zero());
  for (std::size_t c = 0; c < problem_.given().supports.size(); ++c) {
    const Pose& pose = state.poses[index(conditions[c].node)];
    turn[c] = start ? log_rotation(conditions[c].target.rotation * pose.rotation.transpose())
                    : problem_.given().supports[c].motion.rotate;
    moved = moved || turn[c].norm() > 1e-12 ||
            (conditions[c].target.position - pose.position).norm() > 1e-12;
  }
  try {
    bool found = false;
    if (options_.path_steps <= 1) {
      if (moved) turn_along(turn);
      found = jump(start, moved);
    }
    if (!found) {
      state = problem_.state_at(problem_.tree().rest);
      found = follow_path(std::max(options_.path_steps, 4));
    }
    if (found) {
      iteration_.forget();
      judge();
    } else {
      iteration_.take_best();
      summary_.status = Status::iteration_limit;
    }
  } catch (const Interrupted&) {
    problem_.harden();
    problem_.set_time(1);
    iteration_.take_best();
    summary_.status = Status::interrupted;
    summary_.message = "stopped before the end";
  }
  return report_solution(problem_, iteration_.state, summary_);
}

}  // namespace

std::optional<std::string> RodOptions::is_invalid() const {
  return first_fault({
      {time_limit >= 0, "time_limit: expected a number of seconds of at least 0"},
      {std::isfinite(tolerance) && tolerance > 0, "tolerance: expected a number above 0"},
      {max_iterations >= 1, "max_iterations: expected at least 1"},
      {path_steps >= 1, "path_steps: expected at least 1"},
  });
}

std::string RodSummary::brief_report() const {
  return to_string(status) + ": residual " + number_text(residual) + " after " +
         std::to_string(iterations) + " linear solves" + (message.empty() ? "" : "; " + message);
}

RodSolution solve_rod(const RodTree& tree, const RodConditions& conditions,
                      const RodOptions& options, const RodPoses* start) {
  const StopCheck stop(options);
  if (const auto fault = options.is_invalid()) throw InputError("options of the rod: " + *fault);
  check_tree(tree);
  check_conditions(tree, conditions);
  if (start && start->size() != tree.rest.size())
    throw InputError("rod: the start has " + std::to_string(start->size()) + " poses, expected " +
                     std::to_string(tree.rest.size()));
  RodSolution solution = Solver(tree, conditions, options, stop).solve(start);
  solution.summary.seconds = stop.seconds();
  return solution;
}

}  // namespace vasorod
