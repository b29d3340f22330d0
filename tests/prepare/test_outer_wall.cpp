#include <gtest/gtest.h>

#include "prepare/outer_wall.h"
#include "prepare/repair.h"
#include "prepare/tube_shapes.h"
#include "surface_file/check_surface.h"

namespace vasorod::testing {
namespace {

// A thick pipe: outer and inner tube, joined by a ring at each end.
TriangleSurface pipe(double length, double outer, double inner) {
  TubeSpec tube;
  tube.length = length;
  tube.radius = outer;
  const TriangleSurface a = tube_surface(tube);
  tube.radius = inner;
  const TriangleSurface b = tube_surface(tube);
  const int n = static_cast<int>(a.points.rows());
  TriangleSurface out;
  out.points.resize(2 * n, 3);
  out.points << a.points, b.points;
  std::vector<std::array<int, 3>> rings;
  for (const auto& loop : boundary_loops(a.triangles))
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const int u = loop[k], v = loop[(k + 1) % loop.size()];
      rings.push_back({v, u, u + n});
      rings.push_back({v, u + n, v + n});
    }
  const auto m = a.triangles.rows();
  out.triangles.resize(2 * m + static_cast<Eigen::Index>(rings.size()), 3);
  out.triangles.topRows(m) = a.triangles;
  out.triangles.middleRows(m, m) = b.triangles.array() + n;
  out.triangles.middleRows(m, m).col(1).swap(out.triangles.middleRows(m, m).col(2));
  for (std::size_t k = 0; k < rings.size(); ++k)
    out.triangles.row(2 * m + static_cast<Eigen::Index>(k)) << rings[k][0], rings[k][1],
        rings[k][2];
  return out;
}

TEST(OuterWall, OfAPipeIsTheSolidCylinder) {
  const TriangleSurface surface = pipe(40, 5, 4);
  EXPECT_EQ(handles_of(surface), 1);
  const auto wall = outer_wall(surface);
  ASSERT_TRUE(wall);
  EXPECT_EQ(handles_of(wall->surface), 0);
  EXPECT_TRUE(boundary_loops(wall->surface.triangles).empty());
  // The ball dents the open ends by less than its radius.
  const double solid = M_PI * 25 * 40;
  EXPECT_NEAR(lidded_volume(wall->surface), solid, 0.1 * solid);
  for (Eigen::Index i = 0; i < wall->surface.points.rows(); ++i) {
    const Vec3 p = wall->surface.points.row(i);
    if (std::abs(p.z() - 20) < 10) EXPECT_NEAR(p.head<2>().norm(), 5, 0.1);
  }
}

}  // namespace
}  // namespace vasorod::testing
