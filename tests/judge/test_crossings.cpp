#include <Eigen/Geometry>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>

#include "geometry/crossing_triangles.h"
#include "judge/crossings.h"
#include "numerics/threads.h"
#include "straight_tube.h"

namespace vasorod {
namespace {

constexpr double pi = std::numbers::pi;

TriangleSurface tube(double radius, double length, int around, int along) {
  return tube_surface(testing::straight_tube(length, radius, around, along));
}

Points moved(const TriangleSurface& surface, const Mat3& rotation, const Vec3& by) {
  return (surface.points * rotation.transpose()).rowwise() + by.transpose();
}

Mat3 about(const Vec3& axis, double degrees) {
  return Eigen::AngleAxisd(degrees * pi / 180, axis).toRotationMatrix();
}

TEST(Crossings, TubesThatOnlyTouchDoNotCross) {
  for (const int around : {16, 24, 48}) {
    const TriangleSurface a = tube(10, 40, around, 2 * around);
    // Side by side and across, a distance of two radii: facets against edges, half a facet turned.
    for (const double degrees : {0., 90.})
      for (const double turn : {0., 180. / around}) {
        const Points b = moved(a, about(Vec3::UnitX(), degrees) * about(Vec3::UnitZ(), turn),
                               {20 * (1 - 1e-4), 0, degrees == 0 ? 0.37 : 20});
        TriangleSurface rest = a;
        rest.points = moved(a, Mat3::Identity(), {100, 0, 0});
        const auto found = crossings({{&a, &a.points, 10}, {&rest, &b, 10}}, {});
        EXPECT_TRUE(found.empty()) << around << " " << degrees << " " << turn;
      }
  }
}

// Contact ends with vertices that are inside by less than a millionth of an edge.
TEST(Crossings, AVertexOnTheOtherWallDoesNotCross) {
  const TriangleSurface a = tube(10, 40, 24, 48);
  TriangleSurface rest = a;
  rest.points = moved(a, Mat3::Identity(), {100, 0, 0});
  const Points b = moved(a, about(Vec3::UnitZ(), 7), {20.5, 0.3, 0.2});
  Eigen::Index nearest = 0;
  (a.points.rowwise() - Vec3(10, 0, 20).transpose()).rowwise().norm().minCoeff(&nearest);
  const Vec3 out = Vec3::UnitX(), from = a.points.row(nearest);
  double gap = 1e9;
  for (int t = 0; t < a.triangles.rows(); ++t) {  // along x to the other wall
    Mat3 m;
    const Vec3 p = b.row(a.triangles(t, 0)), q = b.row(a.triangles(t, 1)),
               r = b.row(a.triangles(t, 2));
    m << p - q, p - r, out;
    const Vec3 s = m.inverse() * (p - from);
    if (s[0] >= 0 && s[1] >= 0 && s[0] + s[1] <= 1 && s[2] > 0) gap = std::min(gap, s[2]);
  }
  ASSERT_LT(gap, 2);
  for (const double inside : {-1e-9, 1e-9, 1e-7, 1e-5, 1e-3}) {
    Points pulled = a.points;
    pulled.row(nearest) += (gap + inside) * out.transpose();
    EXPECT_TRUE(crossings({{&a, &pulled, 10}, {&rest, &b, 10}}, {}).empty()) << inside;
  }
  Points pulled = a.points;
  pulled.row(nearest) += (gap + 2) * out.transpose();
  EXPECT_EQ(crossings({{&a, &pulled, 10}, {&rest, &b, 10}}, {}).size(), 1U);
}

TEST(Crossings, TubesThatEnterEachOtherDoByTheirDepth) {
  for (const int around : {24, 48}) {
    const TriangleSurface a = tube(10, 40, around, 2 * around);
    TriangleSurface rest = a;
    rest.points = moved(a, Mat3::Identity(), {100, 0, 0});
    for (const double entered : {0.5, 1., 3.}) {
      const Points b = moved(a, about(Vec3::UnitX(), 90), {20 - entered, 20, 20});
      const auto found = crossings({{&a, &a.points, 10}, {&rest, &b, 10}}, {});
      ASSERT_EQ(found.size(), 1U) << entered;
      EXPECT_EQ(found[0].a, 0);
      EXPECT_EQ(found[0].b, 1);
      EXPECT_GT(found[0].pairs, 4);
      // At the vertex closest to where the two axes are closest, one of the two walls' facets.
      const double edge = 20 * pi / around;
      EXPECT_NEAR(found[0].depth, entered, edge * edge / 40 + 0.04 * entered);
      EXPECT_LT((found[0].where - Vec3(10 - entered / 2, 0, 20)).norm(), edge + entered / 2);
    }
  }
}

TEST(Crossings, DoNotDependOnThreads) {
  const TriangleSurface a = tube(10, 40, 48, 96);
  TriangleSurface rest = a;
  rest.points = moved(a, Mat3::Identity(), {100, 0, 0});
  const Points b = moved(a, about(Vec3::UnitX(), 90), {18, 20, 20});
  const auto found = [&](int threads) {
    set_threads(threads);
    const auto crossing = crossings({{&a, &a.points, 10}, {&rest, &b, 10}}, {});
    set_threads(1);
    return crossing;
  };
  const auto one = found(1), four = found(4);
  ASSERT_EQ(one.size(), 1U);
  ASSERT_EQ(four.size(), 1U);
  EXPECT_EQ(four[0].pairs, one[0].pairs);
  EXPECT_EQ(four[0].depth, one[0].depth);
  EXPECT_EQ(four[0].where, one[0].where);
}

TEST(Crossings, WhatCrossesAtRestIsNotCounted) {
  const TriangleSurface a = tube(10, 40, 24, 48);
  TriangleSurface b = a;
  b.points = moved(a, about(Vec3::UnitX(), 90), {17, 20, 20});
  EXPECT_TRUE(crossings({{&a, &a.points, 10}, {&b, &b.points, 10}}, {}).empty());
  // Pushed along its own axis it crosses elsewhere.
  const Points pushed = moved(b, Mat3::Identity(), {0, 0, 12});
  EXPECT_EQ(crossings({{&a, &a.points, 10}, {&b, &pushed, 10}}, {}).size(), 1U);
  // Obstacles have no radius; the vessel's counts. Two obstacles are not checked.
  EXPECT_EQ(crossings({{&a, &a.points, 0}, {&b, &pushed, 10}}, {}).size(), 1U);
  EXPECT_TRUE(crossings({{&a, &a.points, 0}, {&b, &pushed, 0}}, {}).empty());
}

// What one body lies in at rest is measured against that body, whatever was nearer.
TEST(Crossings, AThirdBodyThatWasNearerAtRestChangesNothing) {
  const TriangleSurface a = tube(10, 40, 24, 48);
  TriangleSurface b = a, c = a;
  b.points = moved(a, about(Vec3::UnitX(), 90), {17, 20, 20});
  c.points = moved(a, Mat3::Identity(), {-0.5, 0, 0});
  const Points drawn_out = moved(b, Mat3::Identity(), {0.5, 0, 0}),
               pushed_in = moved(b, Mat3::Identity(), {-1, 0, 0}),
               taken_away = moved(c, Mat3::Identity(), {-100, 0, 0});
  EXPECT_TRUE(
      crossings({{&a, &a.points, 10}, {&b, &drawn_out, 10}, {&c, &taken_away, 10}}, {}).empty());
  const auto found =
      crossings({{&a, &a.points, 10}, {&b, &pushed_in, 10}, {&c, &taken_away, 10}}, {});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].b, 1);
  EXPECT_NEAR(found[0].depth, 4, 0.4);
}

// A tube pressed flat in its middle: until the walls touch, and beyond.
TEST(Crossings, OppositeWallsThatChangeSidesAreFound) {
  const TriangleSurface a = tube(10, 40, 32, 64);
  for (const double width : {0.3, 0.02, -0.1, -0.3}) {
    Points pressed = a.points;
    for (auto point : pressed.rowwise()) {
      const double s = std::exp(-std::pow((point.z() - 20) / 6, 2));
      point.y() *= 1 - s * (1 - width);
    }
    const auto found = crossings({{&a, &pressed, 10}}, {});
    ASSERT_EQ(found.empty(), width > 0) << width;
    if (width > 0) continue;
    EXPECT_EQ(found[0].a, found[0].b);
    EXPECT_NEAR(found[0].where.z(), 20, 1.5);
    EXPECT_GT(found[0].depth, 0.4 * 20 * -width);  // the next wall may be nearer sideways
    EXPECT_LT(found[0].depth, 1.05 * 20 * -width);
  }
}

// Two halves of one tube, joined: the seam's triangles are neighbours, not crossings.
TEST(Crossings, AWeldedSeamIsOneSurface) {
  const int around = 24;
  const TriangleSurface whole = tube(10, 40, around, 40);
  TriangleSurface lower = tube(10, 20, around, 20), upper = lower;
  upper.points = moved(lower, Mat3::Identity(), {0, 0, 20});
  CheckedSeam seam{0, 1, {}};
  for (int i = 0; i < lower.points.rows(); ++i)
    for (int j = 0; j < upper.points.rows(); ++j)
      if ((lower.points.row(i) - upper.points.row(j)).norm() < 1e-9) seam.pairs.push_back({i, j});
  ASSERT_EQ(seam.pairs.size(), static_cast<std::size_t>(around));
  // The seam's gap is closed only up to a tolerance: here one half stands a little inside the
  // other.
  Points shifted = moved(upper, Mat3::Identity(), {0.5, 0.3, -0.4});
  TriangleSurface far = upper;
  far.points = moved(upper, Mat3::Identity(), {0, 0, 50});
  TriangleSurface both;
  both.points.resize(2 * lower.points.rows(), 3);
  both.points << lower.points, shifted;
  both.triangles.resize(2 * lower.triangles.rows(), 3);
  both.triangles << lower.triangles,
      (upper.triangles.array() + static_cast<int>(lower.points.rows())).matrix();
  EXPECT_FALSE(self_intersections(both).empty());
  EXPECT_TRUE(crossings({{&lower, &lower.points, 10}, {&far, &shifted, 10}}, seam).empty());
}

TEST(Crossings, PlacesThatAreNoNumbersAreLeftOut) {
  const TriangleSurface a = tube(10, 40, 24, 48);
  Points broken = a.points;
  broken(7, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(crossings({{&a, &broken, 10}, {&a, &a.points, 10}}, {}).empty());
  EXPECT_TRUE(crossings({}, {}).empty());
}

}  // namespace
}  // namespace vasorod
