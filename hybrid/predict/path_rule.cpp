#include "predict/path_rule.h"

#include <algorithm>
#include <cmath>

#include "judge/validity.h"

namespace vasorod {
namespace {

constexpr double follow_from = 0.7, first_shares[] = {0.25, 0.5}, share_step = 0.05;
constexpr int most_steps = 40;
// A section free to flatten kinks earlier: for t / R 0.1 and L / R 10, between 0.40 and 0.45 of the
// limit.
constexpr double soft_share = 0.5;

}  // namespace

double share_of_limit(const Prediction& prediction) {
  double share = 0;
  for (const PredictedVessel& vessel : prediction.vessels) {
    if (!vessel.rod_solved) continue;
    Validity validity;
    add_validity(vessel.prepared, vessel.rod.poses,
                 {.rigid_nodes = rigid_nodes(prediction, vessel)}, validity);
    const double nu = vessel.prepared.spec.wall->material.poisson_tt;
    const double own = std::max(validity.twist_ratio,
                                validity.wrinkling_ratio * 0.605 / 0.471 * std::sqrt(1 - nu * nu));
    const auto& ends = vessel.conditions.ends;
    const bool soft =
        std::any_of(ends.begin(), ends.end(), [](const ConditionedEnd& end) { return !end.rigid; });
    share = std::max(share, soft ? own / soft_share : own);
  }
  return share;
}

std::vector<double> path_times(double share) {
  if (share < follow_from) return {1};
  std::vector<double> times;
  for (const double early : first_shares) times.push_back(early / share);
  const double first = times.back();
  const int steps =
      std::min(most_steps, static_cast<int>(std::ceil((share - first_shares[1]) / share_step)));
  for (int k = 1; k <= steps; ++k) times.push_back(first + (1 - first) * k / steps);
  times.back() = 1;
  return times;
}

std::vector<double> path_times(const Prediction& prediction) {
  if (prediction.glenn) return {1};
  return path_times(share_of_limit(prediction));
}

}  // namespace vasorod
