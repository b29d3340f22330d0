#include "predict/path_rule.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string>

#include "bodies/reach.h"
#include "geometry/closest_point.h"
#include "judge/lumen_pressure.h"
#include "judge/validity.h"

namespace vasorod {
namespace {

constexpr double follow_from = 0.7, first_shares[] = {0.25, 0.5}, share_step = 0.05;
constexpr int most_steps = 40;
// In collapse pressures, and over the pressure.
constexpr double collapses_from = 0.9, first_pressure = 0.8, pressure_step = 1.0 / 6,
                 pressure_growth = 0.1;
// A section free to flatten kinks earlier: for t / R 0.1 and L / R 10, between 0.40 and 0.45 of the
// limit.
constexpr double soft_share = 0.5;

// Over the radius: how deep the start of a single step may lie inside another vessel, and the step
// of what is pressed deeper.
constexpr double deepest_start = 0.5, way_step = 0.15;

// Bounded before it becomes an int, which would not hold every double.
int steps_of(double wanted) {
  return static_cast<int>(std::min<double>(most_steps, std::ceil(wanted)));
}

// Whether the scene lets the two touch.
bool may_touch(const Prediction& prediction, size_t a, size_t b) {
  const auto& contact = prediction.scene->contact;
  const auto name = [&](size_t v) { return prediction.vessels[v].prepared.spec.name; };
  return !contact ||
         std::any_of(contact->begin(), contact->end(), [&](const std::array<std::string, 2>& pair) {
           return pair == std::array{name(a), name(b)} || pair == std::array{name(b), name(a)};
         });
}

}  // namespace

double share_of_limit(const Prediction& prediction) {
  double share = 0;
  for (const PredictedVessel& vessel : prediction.vessels) {
    if (!vessel.rod_solved) continue;
    Validity validity;
    add_validity(vessel.prepared, vessel.rod.poses,
                 {.rigid_nodes = rigid_nodes(prediction, vessel), .pressed = false}, validity);
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
  const int steps = steps_of((share - first_shares[1]) / share_step);
  for (int k = 1; k <= steps; ++k) times.push_back(first + (1 - first) * k / steps);
  times.back() = 1;
  return times;
}

std::vector<double> pressure_times(double scan, double after, double collapse) {
  if (-after < collapses_from * collapse) return {1};
  std::vector<double> times;
  for (double p = first_pressure * collapse; p < -after && times.size() < most_steps;
       p += std::max(pressure_step * collapse, pressure_growth * p))
    if (const double t = (-p - scan) / (after - scan); t > 0 && t < 1) times.push_back(t);
  times.push_back(1);
  return times;
}

std::vector<double> pressure_times(const PreparedVessel& vessel) {
  if (!vessel.spec.pressure) return {1};
  return pressure_times(
      vessel.spec.pressure->scan, vessel.spec.pressure->after,
      collapse_pressure(vessel.spec.wall->material, vessel.thickness(), vessel.vessel.mean_radius));
}

std::vector<double> pressing_times(double way, double depth) {
  if (depth <= deepest_start) return {1};
  std::vector<double> times;
  const int steps = steps_of(way / way_step);
  for (int k = 1; k <= steps; ++k) times.push_back(static_cast<double>(k) / steps);
  return times;
}

double carried_depth(const Prediction& prediction, size_t vessel) {
  const PredictedVessel& mine = prediction.vessels[vessel];
  if (!mine.rod_solved || mine.prepared.obstacle()) return 0;
  const Points &rest = mine.prepared.vessel.surface.points, now = carried_surface(mine);
  const Box box = box_of(now);
  double deepest = 0;
  for (size_t o = 0; o < prediction.vessels.size(); ++o) {
    if (o == vessel || !may_touch(prediction, vessel, o)) continue;
    const TriangleSurface& surface = prediction.vessels[o].prepared.vessel.surface;
    const Points other = carried_surface(prediction.vessels[o]);
    if (!within_reach(box, box_of(other), 0)) continue;
    const ClosestPoint before(surface), after({other, surface.triangles});
    for (Eigen::Index i = 0; i < now.rows(); ++i) {
      const ClosestPoint::Hit end = after.query(now.row(i));
      if (end.on_boundary || -end.signed_distance <= deepest) continue;
      if (before.query(rest.row(i)).signed_distance > 0) deepest = -end.signed_distance;
    }
  }
  return deepest / mine.prepared.vessel.mean_radius;
}

std::vector<double> path_times(const Prediction& prediction) {
  if (prediction.operation) return {1};
  std::set<double> times;
  const auto add = [&times](const std::vector<double>& more) {
    times.insert(more.begin(), more.end());
  };
  add(path_times(share_of_limit(prediction)));
  for (size_t v = 0; v < prediction.vessels.size(); ++v) {
    const PreparedVessel& prepared = prediction.vessels[v].prepared;
    if (prepared.obstacle()) continue;
    if (const double depth = carried_depth(prediction, v); depth > 0) {
      const Points way = carried_surface(prediction.vessels[v]) - prepared.vessel.surface.points;
      add(pressing_times(way.rowwise().norm().maxCoeff() / prepared.vessel.mean_radius, depth));
    }
    add(pressure_times(prepared));
  }
  return {times.begin(), times.end()};
}

}  // namespace vasorod
