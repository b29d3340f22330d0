#include <Eigen/Geometry>
#include <cmath>
#include <gtest/gtest.h>

#include "geometry/fans.h"
#include "geometry/triangle_surface.h"
#include "straight_tube.h"

namespace vasorod {
namespace {

// A closed tube: no edge is open, and the volume, by the triangles' signed tetrahedra, is that of a
// prism over a polygon of 16 sides: positive, as all triangles face outwards.
TEST(Fans, CloseATubeOutwards) {
  const TriangleSurface tube = tube_surface(testing::straight_tube(10, 2, 16, 12));
  const auto loops = boundary_loops(tube.triangles);
  ASSERT_EQ(loops.size(), 2U);
  const TriangleSurface closed{with_centroids(tube.points, loops),
                               with_fans(tube.triangles, loops, tube.points.rows())};
  EXPECT_EQ(closed.points.rows(), tube.points.rows() + 2);
  EXPECT_EQ(closed.triangles.rows(), tube.triangles.rows() + 32);
  EXPECT_TRUE(boundary_loops(closed.triangles).empty());
  double volume = 0;
  for (const auto& t : closed.triangles.rowwise()) {
    const Vec3 a = closed.points.row(t[0]), b = closed.points.row(t[1]),
               c = closed.points.row(t[2]);
    volume += a.dot(b.cross(c)) / 6;
  }
  const double prism = 16 * 2 * 2 * std::sin(M_PI / 16) * std::cos(M_PI / 16) * 10;
  EXPECT_NEAR(volume, prism, 0.02 * prism) << "rows are staggered";
  EXPECT_LT((closed.points.row(closed.points.rows() - 1) - Vec3(0, 0, 10).transpose()).norm(),
            1e-12);
}

TEST(Fans, WithoutLoopsNothingIsAdded) {
  const TriangleSurface tube = tube_surface(testing::straight_tube(10, 2, 8, 6));
  EXPECT_EQ(with_centroids(tube.points, {}), tube.points);
  EXPECT_EQ(with_fans(tube.triangles, {}, tube.points.rows()), tube.triangles);
}

}  // namespace
}  // namespace vasorod
