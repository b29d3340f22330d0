#include <Eigen/Geometry>
#include <cmath>
#include <gtest/gtest.h>

#include <vasorod/tube.h>

#include "geometry/triangle_surface.h"

namespace vasorod {
namespace {

TubeSpec straight() {
  TubeSpec tube;  // with the default mesh
  tube.length = 100;
  tube.radius = 10;
  return tube;
}

TEST(Tube, HasTheCountsOfTheContract) {
  const auto surface = tube_surface(straight());
  EXPECT_EQ(surface.points.rows(), 3888);
  EXPECT_EQ(surface.triangles.rows(), 7680);
  EXPECT_EQ(euler_number(surface.triangles), 0);
  const auto loops = boundary_loops(surface.triangles);
  ASSERT_EQ(loops.size(), 2U);
  EXPECT_EQ(loops[0].size(), 48U);
  for (const int i : loops[0]) EXPECT_EQ(surface.points(i, 2), 0);
  for (const int i : loops[1]) EXPECT_EQ(surface.points(i, 2), 100);
}

TEST(Tube, FacesOutwardsInEveryTriangle) {
  const auto surface = tube_surface(straight());
  for (int t = 0; t < surface.triangles.rows(); ++t) {
    const Vec3 a = surface.points.row(surface.triangles(t, 0)),
               b = surface.points.row(surface.triangles(t, 1)),
               c = surface.points.row(surface.triangles(t, 2));
    const Vec3 middle = (a + b + c) / 3;
    EXPECT_GT((b - a).cross(c - a).dot(Vec3(middle.x(), middle.y(), 0)), 0) << t;
  }
}

TEST(Tube, IsNearEquilateralWhenRowsAreSpacedSo) {
  TubeSpec tube = straight();
  tube.along = static_cast<int>(
      std::lround(tube.length / (std::sqrt(0.75) * 2 * M_PI * tube.radius / tube.around)));
  const auto surface = tube_surface(tube);
  double shortest = 1e9, longest = 0;
  for (const Edge& e : edges_of(surface.triangles)) {
    const double length = (surface.points.row(e.a) - surface.points.row(e.b)).norm();
    shortest = std::min(shortest, length);
    longest = std::max(longest, length);
  }
  EXPECT_LT(longest / shortest, 1.01);
}

TEST(Tube, BendsAlongACircleTowardsTheNormal) {
  TubeSpec tube = straight();
  tube.bend_deg = 90;
  const double big = tube.length / (M_PI / 2);
  const Vec3 center(big, 0, 0);
  for (const double s : {0.0, 13.0, 50.0, 100.0}) {
    const Pose axis = tube_axis(tube, s);
    EXPECT_NEAR((axis.position - center).norm(), big, 1e-12);
    EXPECT_NEAR((axis.rotation.transpose() * axis.rotation - Mat3::Identity()).norm(), 0, 1e-14);
    EXPECT_NEAR(axis.rotation.determinant(), 1, 1e-14);
    EXPECT_NEAR(axis.director(3).dot(axis.position - center), 0, 1e-11);
    EXPECT_NEAR((axis.director(2) - Vec3::UnitY()).norm(), 0, 1e-14);
  }
  EXPECT_NEAR((tube_axis(tube, 100).position - Vec3(big, 0, big)).norm(), 0, 1e-12);
  EXPECT_NEAR((tube_axis(tube, 100).director(3) - Vec3::UnitX()).norm(), 0, 1e-14);
}

TEST(Tube, EveryVertexLiesOnTheTaperedTorus) {
  TubeSpec tube = straight();
  tube.bend_deg = -60;
  tube.end_radius = 5;
  const auto surface = tube_surface(tube);
  const auto s = tube_arc_lengths(tube);
  for (int i = 0; i < surface.points.rows(); ++i) {
    const Vec3 local = tube_axis(tube, s[i]).inverse() * Vec3(surface.points.row(i));
    EXPECT_NEAR(local.z(), 0, 1e-11);
    EXPECT_NEAR(local.norm(), 10 - 5 * s[i] / 100, 1e-11);
  }
}

TEST(Tube, AreaOfAFineTorusPieceMatchesPappus) {
  TubeSpec tube = straight();
  tube.bend_deg = 120;
  tube.around = 192;
  tube.along = 400;
  // Pappus: the centroid of a circle is on the axis, so the area is that of the straight tube.
  EXPECT_NEAR(total_area(tube_surface(tube)) / (2 * M_PI * 10 * 100), 1, 2e-4);
}

TEST(Tube, PlacementIsARigidMotion) {
  TubeSpec tube = straight();
  tube.bend_deg = 40;
  const auto before = tube_surface(tube);
  const Mat3 turn = Eigen::AngleAxisd(1.1, Vec3(1, -2, 0.5).normalized()).toRotationMatrix();
  tube.position = Vec3(3, -7, 11);
  tube.tangent = turn * Vec3::UnitZ();
  tube.normal = turn * Vec3::UnitX();
  const auto after = tube_surface(tube);
  for (int i = 0; i < before.points.rows(); ++i)
    EXPECT_NEAR(
        (turn * before.points.row(i).transpose() + tube.position - after.points.row(i).transpose())
            .norm(),
        0, 1e-11);
}

TEST(Tube, ThicknessTapersLinearly) {
  TubeSpec tube = straight();
  tube.end_thickness = 0.5;
  const auto thickness = tube_thickness(tube, 1.5);
  EXPECT_DOUBLE_EQ(thickness[0], 1.5);
  EXPECT_DOUBLE_EQ(thickness[thickness.size() - 1], 0.5);
  EXPECT_NEAR(thickness.mean(), 1.0, 1e-12);
}

}  // namespace
}  // namespace vasorod
