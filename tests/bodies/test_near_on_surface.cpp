#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "bodies/near_on_surface.h"
#include "straight_tube.h"

namespace vasorod {
namespace {

constexpr double radius = 5, length = 20;

// On a cylinder, distances along the surface are those of the unrolled sheet; along edges they are
// longer by at most 2 / sqrt(3), the worst direction between those of equilateral triangles.
TEST(NearOnSurface, CountsDistancesAlongTheSurface) {
  const TriangleSurface tube = tube_surface(testing::straight_tube(length, radius, 32, 23));
  const double limit = 6;
  const NearOnSurface near(tube, limit);
  int near_ones = 0, far_ones = 0;
  for (const int a : {0, 100, 351})
    for (int b = 0; b < tube.points.rows(); ++b) {
      const Vec3 p = tube.points.row(a), q = tube.points.row(b);
      double turned = std::abs(std::atan2(p.y(), p.x()) - std::atan2(q.y(), q.x()));
      turned = std::min(turned, 2 * std::numbers::pi - turned);
      const double apart = std::hypot(radius * turned, p.z() - q.z());
      if (apart > 1.01 * limit) {
        EXPECT_FALSE(near.are(a, b)) << a << " " << b;
        ++far_ones;
      } else if (apart < limit * std::sqrt(3) / 2 * 0.99) {
        EXPECT_TRUE(near.are(a, b)) << a << " " << b;
        ++near_ones;
      }
    }
  EXPECT_GT(near_ones, 100);
  EXPECT_GT(far_ones, 1000);
}

// Opposite walls of a tube pressed flat at rest are close in space, and far along the surface.
TEST(NearOnSurface, OppositeWallsAreFar) {
  TriangleSurface tube = tube_surface(testing::straight_tube(length, radius, 32, 23));
  tube.points.col(1) *= 0.05;
  const NearOnSurface near(tube, 2);
  const int top = 10 * 32 + 8, bottom = 10 * 32 + 24;
  ASSERT_LT((tube.points.row(top) - tube.points.row(bottom)).norm(), 0.6);
  EXPECT_FALSE(near.are(top, bottom));
  EXPECT_TRUE(near.are(top, top + 1));
}

}  // namespace
}  // namespace vasorod
