#include <cmath>
#include <gtest/gtest.h>

#include <vasorod/error.h>

#include "geometry/triangle_surface.h"

namespace vasorod {
namespace {

// An open tube of n x m quads split in triangles, oriented outwards: V - E + F = 0, two loops.
TriangleSurface open_tube(int around, int along, double radius, double length) {
  TriangleSurface tube;
  tube.points.resize(around * (along + 1), 3);
  for (int j = 0; j <= along; ++j)
    for (int i = 0; i < around; ++i) {
      const double angle = 2 * M_PI * i / around;
      tube.points.row(j * around + i) << radius * std::cos(angle), radius * std::sin(angle),
          length * j / along;
    }
  tube.triangles.resize(2 * around * along, 3);
  int t = 0;
  for (int j = 0; j < along; ++j)
    for (int i = 0; i < around; ++i) {
      const int a = j * around + i, b = j * around + (i + 1) % around, c = a + around,
                d = b + around;
      tube.triangles.row(t++) << a, b, c;
      tube.triangles.row(t++) << b, d, c;
    }
  return tube;
}

TEST(TriangleSurface, OpenTubeHasEulerNumberZeroAndTwoLoops) {
  const auto tube = open_tube(12, 5, 2, 10);
  EXPECT_EQ(euler_number(tube.triangles), 0);
  const auto loops = boundary_loops(tube.triangles);
  ASSERT_EQ(loops.size(), 2U);
  EXPECT_EQ(loops[0].front(), 0);
  EXPECT_EQ(loops[0].size(), 12U);
}

TEST(TriangleSurface, LoopsRunWithTheSurfaceOnTheirLeft) {
  const auto tube = open_tube(40, 5, 2, 10);
  const auto loops = boundary_loops(tube.triangles);
  // With the surface on the left, seen from outside, the area vector of an end points into the
  // vessel.
  const double polygon_area = 0.5 * 40 * 4 * std::sin(2 * M_PI / 40);
  EXPECT_NEAR((area_vector(tube.points, loops[0]) - Vec3(0, 0, polygon_area)).norm(), 0, 1e-12);
  EXPECT_NEAR((area_vector(tube.points, loops[1]) - Vec3(0, 0, -polygon_area)).norm(), 0, 1e-12);
}

TEST(TriangleSurface, AreasOfAPrismAreExact) {
  const auto tube = open_tube(12, 5, 2, 10);
  const double side = 2 * 2 * std::sin(M_PI / 12);
  EXPECT_NEAR(total_area(tube), 12 * side * 10, 1e-11);
  EXPECT_NEAR(vertex_areas(tube).sum(), total_area(tube), 1e-11);
  EXPECT_NEAR(perimeter(tube.points, boundary_loops(tube.triangles)[0]), 12 * side, 1e-12);
}

TEST(TriangleSurface, NormalsPointOutwards) {
  const auto tube = open_tube(12, 5, 2, 10);
  const Points n = vertex_normals(tube);
  for (int i = 12; i < 60; ++i) {
    const Vec3 radial(tube.points(i, 0), tube.points(i, 1), 0);
    EXPECT_GT(n.row(i).dot(radial.normalized().transpose()), 0.99);
  }
}

TEST(TriangleSurface, ATriangleHasItsNormalAndCentre) {
  TriangleSurface one;
  one.points.resize(3, 3);
  one.points << 1, 0, 2, 4, 0, 2, 1, 6, 2;
  one.triangles.resize(1, 3);
  one.triangles << 0, 1, 2;
  EXPECT_EQ(triangle_normal(one, 0), Vec3(0, 0, 18)) << "twice the area";
  EXPECT_EQ(triangle_center(one, 0), Vec3(2, 2, 2));
}

TEST(TriangleSurface, APartHasItsTrianglesAndTheirPoints) {
  const TriangleSurface whole = open_tube(12, 5, 2, 10);
  const std::vector<int> rows{7, 3, 40};
  const TriangleSurface part = part_with(whole, rows);
  ASSERT_EQ(part.triangles.rows(), 3);
  EXPECT_LE(part.points.rows(), 9);
  for (int t = 0; t < 3; ++t)
    for (int k = 0; k < 3; ++k)
      EXPECT_EQ(part.points.row(part.triangles(t, k)),
                whole.points.row(whole.triangles(rows[static_cast<size_t>(t)], k)));
  EXPECT_EQ(part.triangles.maxCoeff(), part.points.rows() - 1) << "no other points";
  EXPECT_EQ(part_with(whole, {}).points.rows(), 0);
}

TEST(TriangleSurface, ThreeTrianglesOnOneEdgeAreRefused) {
  Triangles t(3, 3);
  t << 0, 1, 2, 1, 0, 3, 0, 1, 4;
  EXPECT_THROW(edges_of(t), InputError);
}

TEST(TriangleSurface, ComponentsAreCounted) {
  Triangles t(2, 3);
  t << 0, 1, 2, 4, 5, 6;
  EXPECT_EQ(components(t, 7), (std::vector<int>{0, 0, 0, -1, 1, 1, 1}));
}

}  // namespace
}  // namespace vasorod
