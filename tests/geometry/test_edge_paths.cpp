#include <cmath>
#include <gtest/gtest.h>

#include "geometry/edge_paths.h"

namespace vasorod {
namespace {

// A strip of squares of side 1, each cut by the diagonal from its lower left to its upper right:
// vertex 2 k lies below vertex 2 k + 1 at x = k.
TriangleSurface strip(int squares) {
  TriangleSurface surface;
  surface.points.resize(2 * squares + 2, 3);
  surface.triangles.resize(2 * squares, 3);
  for (int k = 0; k <= squares; ++k)
    for (const int up : {0, 1}) surface.points.row(2 * k + up) << k, up, 0;
  for (int k = 0; k < squares; ++k) {
    surface.triangles.row(2 * k) << 2 * k, 2 * k + 2, 2 * k + 3;
    surface.triangles.row(2 * k + 1) << 2 * k, 2 * k + 3, 2 * k + 1;
  }
  return surface;
}

TEST(EdgePaths, AreTheShortestUpToTheLimit) {
  const auto ways = EdgePaths(strip(6)).within({0}, 3.5);
  EXPECT_EQ(ways.at(0), 0);
  EXPECT_EQ(ways.at(1), 1);
  EXPECT_EQ(ways.at(6), 3);
  EXPECT_DOUBLE_EQ(ways.at(5), 1 + std::sqrt(2)) << "along the bottom and one diagonal up";
  EXPECT_DOUBLE_EQ(ways.at(7), 2 + std::sqrt(2));
  EXPECT_FALSE(ways.contains(8)) << "4 away";
  EXPECT_EQ(ways.size(), 8U);
}

TEST(EdgePaths, CountEdgesFromTheNearestSource) {
  const auto ways = EdgePaths(strip(6), EdgePaths::Measure::edges).within({0, 12}, 2);
  EXPECT_EQ(ways.at(3), 1) << "a diagonal is one edge";
  EXPECT_EQ(ways.at(10), 1);
  EXPECT_EQ(ways.at(11), 2) << "down to vertex 10 or up to 13 first";
  EXPECT_FALSE(ways.contains(6));
}

TEST(EdgePaths, WithoutSourcesNothingIsNear) {
  EXPECT_TRUE(EdgePaths(strip(2)).within({}, 100).empty());
}

}  // namespace
}  // namespace vasorod
