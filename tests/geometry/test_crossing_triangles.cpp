#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <Eigen/Geometry>
#include <algorithm>
#include <gtest/gtest.h>
#include <iterator>
#include <random>
#include <utility>

#include "geometry/crossing_triangles.h"
#include "geometry/triangle_surface.h"
#include "straight_tube.h"
#include "surface_file/cgal_surface.h"

namespace vasorod {
namespace {

constexpr std::size_t most = 100000;

std::vector<char> all(const TriangleSurface& surface) {
  return std::vector<char>(static_cast<std::size_t>(surface.triangles.rows()), 1);
}

// Those of CGAL.
std::vector<std::array<int, 2>> of_cgal(const TriangleSurface& surface) {
  const CgalMesh mesh = to_cgal(surface);
  std::vector<std::pair<CgalMesh::Face_index, CgalMesh::Face_index>> found;
  CGAL::Polygon_mesh_processing::self_intersections(mesh, std::back_inserter(found));
  std::vector<std::array<int, 2>> pairs;
  for (const auto& [a, b] : found) {
    const int i = static_cast<int>(a.idx()), j = static_cast<int>(b.idx());
    pairs.push_back({std::min(i, j), std::max(i, j)});
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

TriangleSurface tube() {
  return tube_surface(testing::straight_tube(40, 10, 24, 30));
}

TriangleSurface together(TriangleSurface a, const TriangleSurface& b) {
  append(a, b);
  return a;
}

TEST(CrossingTriangles, AreThoseOfCgal) {
  const TriangleSurface one = tube();
  EXPECT_TRUE(crossing_triangles(one, all(one), most).empty());
  for (const double entered : {-0.1, 0.0, 0.3, 4.0, 9.0}) {
    TriangleSurface other = one;
    other.points =
        (one.points * Eigen::AngleAxisd(-1.3, Vec3::UnitX()).toRotationMatrix()).rowwise() +
        Vec3(20 - entered, 17, 20).transpose();
    const TriangleSurface both = together(one, other);
    const auto expected = of_cgal(both);
    EXPECT_EQ(crossing_triangles(both, all(both), most), expected) << entered;
    EXPECT_EQ(expected.empty(), entered <= 0) << entered;
    // All pairs are between the two: either one marked has them all.
    std::vector<char> second = all(both);
    std::fill(second.begin(), second.begin() + one.triangles.rows(), 0);
    EXPECT_EQ(crossing_triangles(both, second, most), expected) << entered;
    EXPECT_TRUE(crossing_triangles(both, std::vector<char>(second.size(), 0), most).empty());
  }
}

// Vertices thrown about: neighbours over a vertex cross, and neighbours over an edge fold.
TEST(CrossingTriangles, AreThoseOfCgalInACrumpledSurface) {
  std::mt19937 random(11);
  for (const double thrown : {1.0, 1.5, 4.0}) {
    TriangleSurface surface = tube();
    std::uniform_real_distribution<double> off(-thrown, thrown);
    for (double& x : surface.points.reshaped()) x += off(random);
    const auto expected = of_cgal(surface);
    EXPECT_GT(expected.size(), 10U) << thrown;
    EXPECT_EQ(crossing_triangles(surface, all(surface), most), expected) << thrown;
    EXPECT_EQ(self_intersections(surface), expected) << thrown;
    EXPECT_EQ(crossing_triangles(surface, all(surface), 7).size(), 7U);
  }
}

// Enough of them for several parts, of which each may be enough.
TEST(CrossingTriangles, DoNotDependOnTheThreads) {
  std::mt19937 random(11);
  TriangleSurface surface = tube_surface(testing::straight_tube(40, 10, 48, 60));
  std::uniform_real_distribution<double> off(-1, 1);
  for (double& x : surface.points.reshaped()) x += off(random);
  const std::size_t count = of_cgal(surface).size();
  EXPECT_GT(count, 200U);
  for (const std::size_t at_most : {count + 1, count, count - 1, count / 3, std::size_t{5}}) {
    const auto alone = crossing_triangles(surface, all(surface), at_most);
    EXPECT_EQ(alone.size(), std::min(count, at_most));
    for (int repeat = 0; repeat < 20; ++repeat)
      ASSERT_EQ(crossing_triangles(surface, all(surface), at_most, 3), alone) << at_most;
  }
}

// In one plane nothing is decided by which side a point is on: folded neighbours overlap.
TEST(CrossingTriangles, OverlapsInAPlaneAndTrianglesWithoutAreaAreFound) {
  TriangleSurface surface;
  surface.points.resize(6, 3);
  surface.points << 0, 0, 0, 1, 0, 0, 0, 1, 0, 0.3, 0.8, 0, 2, 0, 0, 3, 0, 0;
  surface.triangles.resize(3, 3);
  surface.triangles << 0, 1, 2, 1, 0, 3, 1, 4, 5;
  EXPECT_EQ(crossing_triangles(surface, all(surface), most),
            (std::vector<std::array<int, 2>>{{0, 1}, {2, 2}}));
  surface.points.row(3) << 0.3, -0.8, 0;  // unfolded
  EXPECT_EQ(crossing_triangles(surface, all(surface), most),
            (std::vector<std::array<int, 2>>{{2, 2}}));
}

}  // namespace
}  // namespace vasorod
