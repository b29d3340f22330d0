#include <gtest/gtest.h>

#include "geometry/noisy_tube.h"
#include "surgery/cap.h"
#include "surgery/surface_checks.h"

namespace vasorod {
namespace {

TEST(Cap, ClosesARoundHoleWithNearEquilateralTrianglesInItsPlane) {
  testing::TubeShape shape;
  shape.around = 48;
  shape.along = 40;
  const auto tube = testing::noisy_tube(shape);
  for (const auto& loop : boundary_loops(tube.triangles)) {
    const auto capped = close_planar_hole(tube, loop);
    ASSERT_TRUE(testing::oriented(capped.surface.triangles));
    EXPECT_EQ(euler_number(capped.surface.triangles), 1);
    EXPECT_EQ(boundary_loops(capped.surface.triangles).size(), 1U);
    EXPECT_NEAR(total_area(capped.surface) - total_area(tube),
                area_vector(tube.points, loop).norm(), 1e-10);
    EXPECT_LT(testing::source_error(tube, capped.surface, capped.sources), 1e-12);
    const auto made = testing::made_by_surgery(tube, capped.surface, capped.sources);
    EXPECT_GT(made.smallest_angle, 25);
    for (Eigen::Index v = tube.points.rows(); v < capped.surface.points.rows(); ++v)
      EXPECT_NEAR(capped.surface.points(v, 2), tube.points(loop.front(), 2), 1e-12);
  }
}

TEST(Cap, ClosesADentedHole) {
  // A fan of one triangle per side of an L-shaped outline, seen from below.
  const std::vector<Vec2> outline{{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 4}, {0, 4}};
  TriangleSurface skirt;
  skirt.points.resize(12, 3);
  skirt.triangles.resize(12, 3);
  for (int k = 0; k < 6; ++k) {
    const Vec2& p = outline[static_cast<size_t>(k)];
    skirt.points.row(k) << p.x(), p.y(), 0;
    skirt.points.row(k + 6) << p.x(), p.y(), -1;
    const int next = (k + 1) % 6;
    skirt.triangles.row(2 * k) << k + 6, next + 6, k;
    skirt.triangles.row(2 * k + 1) << next + 6, next, k;
  }
  const auto loops = boundary_loops(skirt.triangles);
  ASSERT_EQ(loops.size(), 2U);
  const auto capped = close_planar_hole(skirt, loops[0]);
  EXPECT_TRUE(testing::oriented(capped.surface.triangles));
  EXPECT_EQ(euler_number(capped.surface.triangles), 1);
  EXPECT_NEAR(total_area(capped.surface) - total_area(skirt), 7, 1e-12);  // 4 + 3 squares
}

}  // namespace
}  // namespace vasorod
