#include "reference_fem/tube.h"

#include <cmath>
#include <numbers>

#include "geometry/rigid_motion.h"
#include "reference_fem/section.h"

namespace vasorod::fem {

Pose TubeShape::section(double s) const {
  const double angle = s * bend;
  // (1 - cos a) / a and sin a / a through half angles: exact also as a -> 0
  const double half = angle / 2,
               sinc = std::abs(half) < 1e-8 ? 1 - half * half / 6 : std::sin(half) / half;
  const double chord = s * length * sinc;
  Pose local;
  local.position = Vec3(chord * std::sin(half), 0, chord * std::cos(half));
  local.rotation = exp_rotation(Vec3(0, angle, 0));  // d3 turns towards d1
  return placement * local;
}

Vec3 TubeShape::point(const Vec3& p) const {
  const double angle = 2 * std::numbers::pi * p[0];
  const double r = radius_at(p[1]) + (p[2] - 0.5) * thickness_at(p[1]);
  return section(p[1]) * Vec3(r * std::cos(angle), r * std::sin(angle), 0);
}

Vec3 TubeShape::parameters(const Vec3& point) const {
  const Vec3 x = placement.inverse() * point;
  double s = x[2] / length;
  if (bend != 0) {
    const double turn = length / bend, side = turn > 0 ? 1 : -1;  // signed radius of the axis
    double angle = std::atan2(side * x[2], side * (turn - x[0])) / bend;
    if (angle < -0.5 * (2 * std::numbers::pi / std::abs(bend) - 1))
      angle += 2 * std::numbers::pi / std::abs(bend);
    s = angle;
  }
  const Vec3 y = section(s).inverse() * point;
  double angle = std::atan2(y[1], y[0]) / (2 * std::numbers::pi);
  if (angle < 0) angle += 1;
  if (angle >= 1 - 1e-14) angle = 0;
  return {angle, s, (std::hypot(y[0], y[1]) - radius_at(s)) / thickness_at(s) + 0.5};
}

Mat3 TubeShape::axes(const Vec3& p) const {
  const double c = std::cos(2 * std::numbers::pi * p[0]), s = std::sin(2 * std::numbers::pi * p[0]);
  Mat3 local;
  local << c, -s, 0, s, c, 0, 0, 0, 1;
  return section(p[1]).rotation * local;
}

}  // namespace vasorod::fem
