#include "surgery/vein_rotation.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "rod/energy.h"
#include "surgery/pose.h"

namespace vasorod {

VeinRotation::VeinRotation(const RodTree& rod, const RodConditions& conditions, int mouth_node,
                           const Pose& mouth, const Vec3& axis, RodOptions options)
    : rod_(rod),
      held_(conditions),
      mouth_node_(mouth_node),
      mouth_(mouth),
      axis_(axis.normalized()),
      options_(std::move(options)) {}

Pose VeinRotation::mouth_at(double angle) const {
  return {Eigen::AngleAxisd(angle, axis_).toRotationMatrix() * mouth_.rotation, mouth_.position};
}

RodConditions VeinRotation::conditions_at(double angle) const {
  RodConditions conditions = held_;
  conditions.supports.push_back(clamp_at(rod_, mouth_node_, mouth_at(angle)));
  return conditions;
}

const RodSolution& VeinRotation::at(double angle) {
  const auto known = solved_.find(angle);
  if (known != solved_.end()) return known->second;
  const RodPoses* start = nullptr;
  double nearest = std::numeric_limits<double>::infinity();
  for (const auto& [other, solution] : solved_)
    if (solution.summary.status == Status::converged && std::abs(other - angle) < nearest) {
      nearest = std::abs(other - angle);
      start = &solution.poses;
    }
  RodSolution solution = solve_rod(rod_, conditions_at(angle), options_, start);
  return solved_.emplace(angle, std::move(solution)).first->second;
}

double VeinRotation::largest_twist_shear(double angle) {
  const RodSolution& solution = at(angle);
  if (solution.summary.status != Status::converged) return std::numeric_limits<double>::infinity();
  double largest = 0;
  for (const RodElement& element : rod_.elements) {
    const Vec6 strain = element_strain(element, solution.poses[static_cast<size_t>(element.first)],
                                       solution.poses[static_cast<size_t>(element.second)]);
    const double twist = strain[5] - element.rest_strain[5];
    const double radius = std::max(rod_.radius[static_cast<size_t>(element.first)],
                                   rod_.radius[static_cast<size_t>(element.second)]);
    largest = std::max(largest, radius * std::abs(twist));
  }
  return largest;
}

double VeinRotation::find() {
  // From rest to angle 0, and from there in small steps in both directions, so that every angle is
  // reached with its own twist, without a full turn more or less.
  at(0);
  for (int k = 1; k <= 12; ++k)
    for (const double sign : {1.0, -1.0}) at(sign * k * M_PI / 12);
  return minimise_on_circle([this](double angle) { return largest_twist_shear(angle); }).angle;
}

}  // namespace vasorod
