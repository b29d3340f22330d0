#include <gtest/gtest.h>

#include "geometry/closest_point.h"
#include "infant_anatomy.h"
#include "prepare/part_walls.h"
#include "prepare/repair.h"
#include "prepare/tube_shapes.h"
#include "real_anatomy.h"
#include "surface_file/check_surface.h"
#include "surface_file/read_polydata.h"

namespace vasorod::testing {
namespace {

TriangleSurface tube(double radius) {
  TubeSpec spec;
  spec.length = 40;
  spec.radius = radius;
  return tube_surface(spec);
}

// Largest distance from the points of one surface to the other.
double distance(const TriangleSurface& from, const TriangleSurface& to) {
  const ClosestPoint wall(to);
  double largest = 0;
  for (const auto p : from.points.rowwise())
    largest = std::max(largest, (wall.query(p).point - p.transpose()).norm());
  return largest;
}

TEST(PartWalls, ThePipesOuterTubeIsKeptPointForPoint) {
  const TriangleSurface outer = tube(5);
  for (const double thickness : {0.2, 1.0, 2.0}) {
    const auto parted = part_walls(double_wall(outer, thickness));
    ASSERT_TRUE(parted) << thickness;
    EXPECT_NEAR(parted->thickness, thickness, 0.05 * thickness);
    EXPECT_EQ(parted->outer.points.rows(), outer.points.rows());
    EXPECT_EQ(parted->outer.triangles.rows(), outer.triangles.rows());
    EXPECT_EQ(distance(parted->outer, outer), 0);
    EXPECT_NEAR(lidded_volume(parted->outer), lidded_volume(outer), 1e-9);
  }
}

TEST(PartWalls, ForksStayAsTheyAre) {
  for (const std::string name : {"pulmonary_artery", "aorta"}) {
    const TriangleSurface outer = infant(name);
    const auto parted = part_walls(double_wall(outer, 0.6));
    ASSERT_TRUE(parted) << name;
    EXPECT_EQ(parted->outer.triangles.rows(), outer.triangles.rows()) << name;
    EXPECT_EQ(distance(parted->outer, outer), 0) << name;
  }
}

TEST(PartWalls, OneWallIsNotParted) {
  EXPECT_FALSE(part_walls(tube(5)));
  EXPECT_FALSE(part_walls(closed_tube(40, 5, true)));
  EXPECT_FALSE(part_walls(infant("pulmonary_artery")));
}

// Its left end is cut at a slant: some triangles of the rim continue the wall without a crease.
TEST(PartWalls, RealAnatomyKeepsItsForkAndNearlyAllOfItsRims) {
  const TriangleSurface outer = read_polydata(real_anatomy() / "pulmonary_artery.vtp").surface;
  const auto parted = part_walls(double_wall(outer, 0.6));
  ASSERT_TRUE(parted);
  EXPECT_EQ(boundary_loops(parted->outer.triangles).size(), 3U);
  EXPECT_LE(distance(parted->outer, outer), 0.6 + 1e-9);
  EXPECT_NEAR(lidded_volume(parted->outer), lidded_volume(outer), 1e-3 * lidded_volume(outer));
}

}  // namespace
}  // namespace vasorod::testing
