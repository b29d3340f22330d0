// Surfaces with known axes for the tests of tests/vessel.
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <random>

#include <vasorod/types.h>

namespace vasorod::shapes {

/// A tube about an axis that starts at the origin along +z and, if bent, turns towards +x on a
/// circle. Staggered rows, radius linear in arc length.
struct Tube {
  double length = 100, radius = 10, end_radius = 10, bend = 0;  ///< bend: total angle, radians
  int around = 48, along = 80;

  /// The axis at arc length s.
  Vec3 axis(double s) const {
    if (bend == 0) return {0, 0, s};
    const double turn = length / bend, angle = s / turn;
    return {turn * (1 - std::cos(angle)), 0, turn * std::sin(angle)};
  }
  Vec3 tangent(double s) const {
    const double angle = bend * s / length;
    return {std::sin(angle), 0, std::cos(angle)};
  }
  double radius_at(double s) const { return radius + (end_radius - radius) * s / length; }

  TriangleSurface surface() const {
    TriangleSurface tube;
    tube.points.resize(around * (along + 1), 3);
    for (int j = 0; j <= along; ++j) {
      const double s = length * j / along;
      const Vec3 t = tangent(s), d1(t.z(), 0, -t.x()), d2 = Vec3::UnitY();
      for (int i = 0; i < around; ++i) {
        const double angle = 2 * M_PI * (i + 0.5 * (j % 2)) / around;
        tube.points.row(j * around + i) =
            axis(s) + radius_at(s) * (std::cos(angle) * d1 + std::sin(angle) * d2);
      }
    }
    tube.triangles.resize(2 * around * along, 3);
    int row = 0;
    for (int j = 0; j < along; ++j)
      for (int i = 0; i < around; ++i) {
        const int next = (i + 1) % around, a = j * around + i, b = j * around + next,
                  c = a + around, d = b + around;
        if (j % 2 == 0) {
          tube.triangles.row(row++) << a, b, c;
          tube.triangles.row(row++) << b, d, c;
        } else {
          tube.triangles.row(row++) << a, d, c;
          tube.triangles.row(row++) << a, b, d;
        }
      }
    return tube;
  }
};

inline Pose some_motion() {
  Pose motion;
  motion.rotation = Eigen::AngleAxisd(1.1, Vec3(0.3, -0.8, 0.5).normalized()).toRotationMatrix();
  motion.position = Vec3(-31, 480, 57);
  return motion;
}

inline TriangleSurface moved(const TriangleSurface& surface, const Pose& motion) {
  TriangleSurface result = surface;
  for (Eigen::Index i = 0; i < surface.points.rows(); ++i)
    result.points.row(i) = motion * Vec3(surface.points.row(i));
  return result;
}

inline TriangleSurface noisy(const TriangleSurface& surface, double deviation, unsigned seed = 1) {
  TriangleSurface result = surface;
  std::mt19937 generator(seed);
  std::normal_distribution<double> normal(0, deviation);
  for (Eigen::Index i = 0; i < result.points.size(); ++i)
    result.points.data()[i] += normal(generator);
  return result;
}

}  // namespace vasorod::shapes
