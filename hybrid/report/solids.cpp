#include "report/solids.h"

#include <Eigen/Geometry>
#include <cmath>

namespace vasorod {

TriangleSurface ball(const Vec3& centre, double radius) {
  constexpr int around = 16, rings = 7;  // between the poles
  TriangleSurface surface;
  surface.points.resize(around * rings + 2, 3);
  surface.triangles.resize(2 * around * rings, 3);
  for (int j = 0; j < rings; ++j)
    for (int i = 0; i < around; ++i) {
      const double polar = M_PI * (j + 1) / (rings + 1), angle = 2 * M_PI * i / around;
      const Vec3 normal(std::sin(polar) * std::cos(angle), std::sin(polar) * std::sin(angle),
                        std::cos(polar));
      surface.points.row(around * j + i) = (centre + radius * normal).transpose();
    }
  const int north = around * rings, south = north + 1;
  surface.points.row(north) = (centre + radius * Vec3::UnitZ()).transpose();
  surface.points.row(south) = (centre - radius * Vec3::UnitZ()).transpose();
  Eigen::Index t = 0;
  for (int i = 0; i < around; ++i) {
    const int next = (i + 1) % around, last = around * (rings - 1);
    surface.triangles.row(t++) << north, i, next;
    surface.triangles.row(t++) << south, last + next, last + i;
    for (int j = 0; j + 1 < rings; ++j) {
      const int a = around * j + i, b = around * j + next;
      surface.triangles.row(t++) << a, a + around, b;
      surface.triangles.row(t++) << b, a + around, b + around;
    }
  }
  return surface;
}

TriangleSurface stick(const Vec3& from, const Vec3& to, double radius) {
  constexpr int sides = 8;
  const Vec3 along = (to - from).normalized(), x = along.unitOrthogonal(), y = along.cross(x);
  TriangleSurface surface;
  surface.points.resize(2 * sides, 3);
  surface.triangles.resize(2 * sides, 3);
  for (int i = 0; i < sides; ++i) {
    const double angle = 2 * M_PI * i / sides;
    const Vec3 spoke = radius * (std::cos(angle) * x + std::sin(angle) * y);
    surface.points.row(i) = (from + spoke).transpose();
    surface.points.row(sides + i) = (to + spoke).transpose();
    const int next = (i + 1) % sides;
    surface.triangles.row(2 * i) << i, next, sides + i;
    surface.triangles.row(2 * i + 1) << next, sides + next, sides + i;
  }
  return surface;
}

}  // namespace vasorod
