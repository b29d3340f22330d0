// Finds the rotation of the vein about its axis at the join that minimises the largest twist shear
// of its rod.
#pragma once

#include <functional>
#include <map>
#include <optional>

#include "rod/newton.h"

namespace vasorod {

/// Solves the vein's rod for poses of its mouth that differ by a rotation about the mouth's axis.
class VeinRotation {
 public:
  /// `conditions` hold the kept far end; `mouth` is the mouth's pose at angle 0. Angles (radians)
  /// rotate the mouth about `axis`.
  VeinRotation(const RodTree& rod, const RodConditions& conditions, int mouth_node,
               const Pose& mouth, const Vec3& axis, RodOptions options);

  /// The angle with the smallest value of the largest twist shear.
  double find();
  /// Equilibrium at an angle, continued from the nearest solved angle.
  const RodSolution& at(double angle);
  /// Largest |r (u3 - u3^0)| over the rod at an angle; infinite if no equilibrium was found.
  double largest_twist_shear(double angle);
  /// The conditions with the mouth's support at an angle.
  RodConditions conditions_at(double angle) const;

 private:
  Pose mouth_at(double angle) const;

  const RodTree& rod_;
  RodConditions held_;
  int mouth_node_;
  Pose mouth_;
  Vec3 axis_;
  RodOptions options_;
  std::map<double, RodSolution> solved_;
};

}  // namespace vasorod
