// A straight tube as a prepared vessel, with the poses of simple deformations, for metrics and
// validity.
#pragma once

#include "geometry/rigid_motion.h"
#include "vessel/prepared_vessel.h"
#include "vessel/shapes.h"

namespace vasorod::shapes {

/// Length `length`, mid-wall radius 10, thickness 1, all multiplied by `unit`; E = 0.5 multiplied
/// by `stress`; nu = 0.3.
inline PreparedVessel judged_tube(double length = 100, double unit = 1, double stress = 1) {
  Tube tube;
  tube.length = length * unit;
  tube.radius = tube.end_radius = 10 * unit;
  tube.along = static_cast<int>(0.8 * length);
  PreparedVessel prepared;
  prepared.spec.name = "tube";
  prepared.spec.surface_is = SurfaceIs::mid;
  prepared.spec.wall = Wall{unit, Material::isotropic(0.5 * stress, 0.3)};
  prepared.vessel.surface = tube.surface();
  fit(prepared);
  return prepared;
}

/// Poses of the tube's rod with the strain (0, 0, 1) + `change` in every element.
inline RodPoses strained(const RodTree& rod, const Vec6& change) {
  RodPoses poses = rod.rest;
  for (const RodElement& e : rod.elements)
    poses[static_cast<size_t>(e.second)] =
        poses[static_cast<size_t>(e.first)] * exp_motion(e.length * (e.rest_strain + change));
  return poses;
}

inline Vec6 change_of(double v3, const Vec3& u) {
  Vec6 change;
  change << 0, 0, v3, u;
  return change;
}

}  // namespace vasorod::shapes
