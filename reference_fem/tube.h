// A tube of the scene as an exact chart: straight or bent axis, radius and thickness linear along
// it.
#pragma once

#include "reference_fem/mesh.h"
#include "reference_fem/solid.h"

namespace vasorod::fem {

/// Lengths in one unit. Mid-wall radius and thickness vary linearly from start to end.
struct TubeShape {
  double length = 1, radius = 1, thickness = 0.1;
  double end_radius = 1, end_thickness = 0.1;
  double bend = 0;  ///< radians: total angle of the circular axis, turning towards `normal`
  Pose placement;   ///< frame of the start section: d3 the axis, d1 the normal

  double radius_at(double s) const { return radius + s * (end_radius - radius); }  ///< s in [0, 1]
  double thickness_at(double s) const { return thickness + s * (end_thickness - thickness); }
  double mean_radius() const { return (radius + end_radius) / 2; }
  /// Section frame at the fraction s of the axis.
  Pose section(double s) const;
  /// Maps parameters (angle / 2 pi from d1 towards d2, s, depth from inner 0 to outer 1) to space.
  Vec3 point(const Vec3& parameter) const;
  /// Inverse of `point`: angle in [0, 1), s and depth unbounded. For points near the tube; its axis
  /// must not be a full circle.
  Vec3 parameters(const Vec3& point) const;
  /// Local axes: radial, hoop, axis tangent (the fibre), as columns.
  Mat3 axes(const Vec3& parameter) const;
};

}  // namespace vasorod::fem
