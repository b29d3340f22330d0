// Irregular test surfaces without other dependencies: bent, tapered, jittered open tubes.
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <random>

#include <vasorod/types.h>

namespace vasorod::testing {

/// An open tube around a circular arc (or the z axis if `bend` is 0). `jitter` (fraction of an
/// edge) displaces every vertex randomly within the surface; diagonals are flipped, so that no two
/// triangles are equal.
struct TubeShape {
  int around = 24, along = 30;
  double radius = 5, length = 40;
  double bend = 0;    ///< total angle of the axis, radians, turning towards +x
  double jitter = 0;  ///< fraction of an edge, below 0.3
  unsigned seed = 1;
};

/// A tube bent to a U, its sides 38 apart: a plane across one leg meets the other, too.
inline TubeShape u_bend() {
  TubeShape shape;
  shape.length = 60;
  shape.along = 45;
  shape.bend = M_PI;
  shape.jitter = 0.2;
  return shape;
}

/// The i-th of many irregular shapes: `around` vertices, straight where 3 divides i and otherwise
/// bent by up to `bend`, jittered unless 5 divides i.
inline TubeShape irregular_shape(int i, int around, double bend, std::mt19937& random) {
  std::uniform_real_distribution<double> uniform(0, 1);
  TubeShape shape;
  shape.around = around;
  shape.along = static_cast<int>(around * 1.4);
  shape.bend = i % 3 == 0 ? 0 : bend * uniform(random);
  shape.jitter = i % 5 == 0 ? 0 : 0.28 * uniform(random);
  shape.seed = static_cast<unsigned>(i + 1);
  return shape;
}

/// A point at angle theta and arc length s of the tube, at distance `radius` from its axis.
inline Vec3 on_tube(const TubeShape& shape, double theta, double s, double radius) {
  const Vec3 section(radius * std::cos(theta), radius * std::sin(theta), 0);
  if (shape.bend == 0) return section + Vec3(0, 0, s);
  const double arc = shape.length / shape.bend, angle = s / arc;
  const Eigen::AngleAxisd turn(angle, Vec3::UnitY());
  return turn * (section - Vec3(arc, 0, 0)) + Vec3(arc, 0, 0);
}

/// The frame of the tube's section at arc length s.
inline Pose tube_frame(const TubeShape& shape, double s) {
  Pose pose;
  pose.position = on_tube(shape, 0, s, 0);
  if (shape.bend != 0)
    pose.rotation =
        Eigen::AngleAxisd(s * shape.bend / shape.length, Vec3::UnitY()).toRotationMatrix();
  return pose;
}

inline TriangleSurface noisy_tube(const TubeShape& shape) {
  std::mt19937 random(shape.seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  TriangleSurface tube;
  const int n = shape.around, m = shape.along;
  tube.points.resize(n * (m + 1), 3);
  for (int j = 0; j <= m; ++j)
    for (int i = 0; i < n; ++i) {
      const double inside = (j == 0 || j == m) ? 0 : 1;  // the ends stay plane
      const double theta = 2 * M_PI / n * (i + 0.5 * j + shape.jitter * uniform(random));
      const double s = shape.length / m * (j + inside * shape.jitter * uniform(random));
      tube.points.row(j * n + i) = on_tube(shape, theta, s, shape.radius);
    }
  tube.triangles.resize(2 * n * m, 3);
  int t = 0;
  for (int j = 0; j < m; ++j)
    for (int i = 0; i < n; ++i) {
      const int a = j * n + i, b = j * n + (i + 1) % n;  // this row
      const int c = a + n, e = b + n;  // the next row, half an edge further around
      if (shape.jitter > 0 && uniform(random) > 0.8) {
        tube.triangles.row(t++) << a, b, e;
        tube.triangles.row(t++) << a, e, c;
      } else {
        tube.triangles.row(t++) << a, b, c;
        tube.triangles.row(t++) << b, e, c;
      }
    }
  return tube;
}

}  // namespace vasorod::testing
