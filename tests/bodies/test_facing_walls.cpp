#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "bodies/facing_walls.h"
#include "bodies/hairpin.h"
#include "straight_tube.h"

namespace vasorod {
namespace {

constexpr int around = 32, along = 12;
constexpr double radius = 5;

TriangleSurface tube() {
  return tube_surface(testing::straight_tube(12, radius, around, along));
}

const auto nothing = [](const std::array<int, 3>&) { return false; };

bool beside_the_end(const TriangleSurface& surface, int vertex) {
  return surface.points(vertex, 2) < 1 || surface.points(vertex, 2) > 11;
}

TEST(FacingWalls, ARoundTubeFacesItselfAcrossItsAxis) {
  const TriangleSurface rest = tube();
  const FacingWalls walls(rest);
  const double sagitta = radius * (1 - std::cos(M_PI / around));
  for (int i = around; i < 2 * around; ++i) {
    const auto own = [i](const std::array<int, 3>& corner) {
      return corner[0] == i || corner[1] == i || corner[2] == i;
    };
    double seen = 0;
    const FacingWall met = walls.first(i, false, 20, own, seen);
    ASSERT_GE(met.triangle, 0);
    const Vec3 opposite(-rest.points(i, 0), -rest.points(i, 1), rest.points(i, 2));
    EXPECT_LT((met.at - opposite).norm(), 1.01 * sagitta + 1e-9);
    EXPECT_NEAR(seen, 2 * radius, 1.01 * sagitta);
    EXPECT_NEAR(met.normal.dot(opposite) / opposite.head<2>().norm(), 1, 0.01);
    EXPECT_LT(walls.first(i, true, 20, own, seen).triangle, 0);
    EXPECT_EQ(seen, 20) << "outside there is nothing";
    EXPECT_EQ(walls.winding_outside(i), 0);
  }
}

TEST(FacingWalls, WhatIsSkippedOrTooFarIsNotFound) {
  const FacingWalls walls(tube());
  double seen = 0;
  const auto all = [](const std::array<int, 3>&) { return true; };
  EXPECT_LT(walls.first(around + 3, false, 20, all, seen).triangle, 0);
  EXPECT_EQ(seen, 20);
  const auto close = [&](const std::array<int, 3>& corner) {
    return std::any_of(corner.begin(), corner.end(), [](int v) { return v == around + 3; });
  };
  EXPECT_LT(walls.first(around + 3, false, 9, close, seen).triangle, 0);
  EXPECT_GE(walls.first(around + 3, false, 11, close, seen).triangle, 0);
}

// The top and bottom of a lumen have passed through each other in the middle: the space between
// them there is inside out, the lobes beside it are not.
TEST(FacingWalls, WallsThroughEachOtherAreInsideOut) {
  const TriangleSurface rest = tube();
  FacingWalls walls(rest);
  Points now = rest.points;
  for (Eigen::Index i = 0; i < now.rows(); ++i) {
    const double height = std::abs(now(i, 0)) < 2.5 ? -0.3 : 1;
    now(i, 1) *= height / radius;
  }
  walls.refit(now);
  int inside_out = 0, right = 0;
  for (int i = 0; i < now.rows(); ++i) {
    const double x = std::abs(now(i, 0));
    if (beside_the_end(rest, i)) continue;
    if (x < 1.5 && std::abs(now(i, 1)) > 0.1) {
      // The normals have turned with the triangles, so that outside is where the other wall is.
      EXPECT_EQ(walls.winding_outside(i), -1) << i;
      ++inside_out;
    } else if (x > 3.5 && x < 4.5) {
      EXPECT_EQ(walls.winding_outside(i), 0) << i;
      ++right;
    }
  }
  EXPECT_GT(inside_out, 20);
  EXPECT_GT(right, 20);
}

// A tube bent to a ring whose ends overlap side by side: where they are through each other, the
// space outside a vertex lies inside the other leg.
TEST(FacingWalls, WhatLiesInsideAnotherLegIsWoundOnce) {
  const double length = 60, bend = 3.5;
  const TriangleSurface rest = tube_surface(testing::straight_tube(length, radius, around, 60));
  const Points now = testing::hairpin(rest.points, length, bend);
  FacingWalls walls(rest);
  walls.refit(now);
  // Legs of radius 5 with axes 7 apart, well away from the bend and the ends.
  int within = 0, without = 0;
  for (int i = 0; i < now.rows(); ++i) {
    const Vec3 x = now.row(i);
    if (x.z() > -6 || x.z() < -20) continue;
    const bool first = rest.points(i, 2) < length / 2;
    const double other = first ? 2 * bend : 0;
    const double to_other = std::hypot(x.x() - other, x.y());
    if (to_other < radius - 0.5) {
      EXPECT_EQ(walls.winding_outside(i), 1) << i;
      ++within;
    } else if (to_other > radius + 0.5) {
      EXPECT_EQ(walls.winding_outside(i), 0) << i;
      ++without;
    }
  }
  EXPECT_GT(within, 50);
  EXPECT_GT(without, 200);
}

}  // namespace
}  // namespace vasorod
