#include <gtest/gtest.h>

#include "prepare/outer_wall.h"
#include "prepare/repair.h"
#include "prepare/tube_shapes.h"
#include "surface_file/check_surface.h"

namespace vasorod::testing {
namespace {

TEST(OuterWall, OfAPipeIsTheSolidCylinder) {
  TubeSpec tube;
  tube.length = 40;
  tube.radius = 5;
  const TriangleSurface surface = double_wall(tube_surface(tube), 1);
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
    if (std::abs(p.z() - 20) < 10) {
      EXPECT_NEAR(p.head<2>().norm(), 5, 0.1);
    }
  }
}

}  // namespace
}  // namespace vasorod::testing
