#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>

#include "geometry/ray_hits.h"
#include "straight_tube.h"

namespace vasorod {
namespace {

TriangleSurface tube() {
  return tube_surface(testing::straight_tube(40, 10, 36, 40));
}

TEST(RayHits, ARayAcrossATubeEntersAndLeavesIt) {
  const RayHits rays(tube());
  const double sagitta = 10 * (1 - std::cos(std::numbers::pi / 36));
  for (const double aside : {0.0, 3.3, 9.1})
    for (const double degrees : {0.7, 41.3, 187.9}) {
      const double angle = degrees * std::numbers::pi / 180;
      const Vec3 along(std::cos(angle), std::sin(angle), 0), side(-along.y(), along.x(), 0);
      const auto hits = rays.along(Vec3(0, 0, 17.3) + aside * side - 25 * along, along);
      ASSERT_EQ(hits.size(), 2U) << aside << " " << degrees;
      // A chord of the circle; its polygon is up to a sagitta nearer, more where it is grazed.
      const double half = std::sqrt(100 - aside * aside), slack = 1.01 * sagitta * 10 / half;
      EXPECT_NEAR(hits[0].distance, 25 - half, slack);
      EXPECT_NEAR(hits[1].distance, 25 + half, slack);
      EXPECT_FALSE(hits[0].leaves);
      EXPECT_TRUE(hits[1].leaves);
      EXPECT_NE(hits[0].triangle, hits[1].triangle);
    }
}

TEST(RayHits, FromInsideThereIsOneAndBehindNone) {
  const RayHits rays(tube());
  const Vec3 along = Vec3(1, 0.31, 0.07).normalized();
  const auto hits = rays.along({0, 0, 20}, along);
  ASSERT_EQ(hits.size(), 1U);
  EXPECT_TRUE(hits[0].leaves);
  EXPECT_TRUE(rays.along({20, 0, 20}, along).empty());
  EXPECT_TRUE(rays.along({0, 0, 20}, Vec3::UnitZ()).empty());  // out of the open end
}

// What a ray from a vertex hits are the hits of the ray from there but for the vertex's triangles.
TEST(RayHits, AVertexDoesNotMeetItsOwnTriangles) {
  const TriangleSurface surface = tube();
  const RayHits rays(surface);
  const int vertex = 17 * 36 + 5;
  const Vec3 from = surface.points.row(vertex);
  std::vector<RayHit> hits;
  size_t own = 0;
  for (const Vec3& way : {Vec3(-from.x(), -from.y(), 1.3), Vec3(from.x(), from.y(), 1.3)}) {
    rays.along_from(vertex, way.normalized(), 100, hits);
    std::vector<int> expected, found;
    for (const RayHit& hit : rays.along(from, way.normalized(), 100)) {
      const bool is_own = (surface.triangles.row(hit.triangle).array() == vertex).any();
      own += is_own ? 1 : 0;
      if (!is_own) expected.push_back(hit.triangle);
    }
    for (const RayHit& hit : hits) found.push_back(hit.triangle);
    EXPECT_EQ(found, expected);
    EXPECT_EQ(found.size(), way.x() * from.x() < 0 ? 1U : 0U);
  }
  EXPECT_EQ(own, 12U);  // of each ray all six
}

TEST(RayHits, WhatIsFartherThanAskedIsNotFound) {
  const RayHits rays(tube());
  const Vec3 from(-25, 0.4, 17.3);
  EXPECT_EQ(rays.along(from, Vec3::UnitX(), 14).size(), 0U);
  EXPECT_EQ(rays.along(from, Vec3::UnitX(), 20).size(), 1U);
  EXPECT_EQ(rays.along(from, Vec3::UnitX(), 40).size(), 2U);
}

// Walls that a solver has lost: CGAL takes neither a way that rounding swallows nor triangles
// without area nor what is not finite.
TEST(RayHits, WhatIsNoRayOrNoTriangleIsNoHit) {
  const double far = 1e27, infinite = std::numeric_limits<double>::infinity();
  TriangleSurface surface = tube();
  RayHits rays(surface);
  EXPECT_TRUE(rays.along({far, far, 0}, Vec3::UnitX(), 3).empty());
  EXPECT_TRUE(rays.along({infinite, 0, 17.3}, Vec3::UnitX(), 3).empty());
  EXPECT_TRUE(rays.along({0, 0, 17.3}, Vec3::Zero()).empty());
  surface.points.col(0) *= 0;
  surface.points.col(1) *= 0;
  rays.refit(surface.points);
  EXPECT_TRUE(rays.along({-25, 0, 17}, Vec3::UnitX()).empty());
  surface.points.setConstant(infinite);
  rays.refit(surface.points);
  EXPECT_TRUE(rays.along({-25, 0, 17}, Vec3::UnitX()).empty());
  surface.points *= 0;  // not a number
  rays.refit(surface.points);
  EXPECT_TRUE(rays.along({-25, 0, 17}, Vec3::UnitX(), 40).empty());
}

TEST(RayHits, RefitMovesThePoints) {
  TriangleSurface surface = tube();
  RayHits rays(surface);
  surface.points.col(0) *= 0.5;
  rays.refit(surface.points);
  const RayHits built(surface);
  std::vector<RayHit> hits{{7, 7, true}};  // what was there before goes
  for (const double aside : {0.0, 3.3, 9.1}) {
    const Vec3 from(-25, aside, 17.3);
    rays.along(from, Vec3::UnitX(), 50, hits);
    const auto expected = built.along(from, Vec3::UnitX(), 50);
    ASSERT_EQ(hits.size(), 2U);
    for (size_t k = 0; k < 2; ++k) {
      EXPECT_EQ(hits[k].triangle, expected[k].triangle);
      EXPECT_EQ(hits[k].distance, expected[k].distance);
    }
  }
}

TEST(RayHits, DoNotDependOnTheUnit) {
  TriangleSurface small = tube();
  const RayHits rays(small);
  const Vec3 from(-25, 1, 20), along = Vec3(1, 0.1, 0.03).normalized();
  const auto hits = rays.along(from, along);
  small.points *= 1e-6;
  const auto again = RayHits(small).along(1e-6 * from, along);
  ASSERT_EQ(again.size(), hits.size());
  for (std::size_t k = 0; k < hits.size(); ++k) {
    EXPECT_EQ(again[k].triangle, hits[k].triangle);
    EXPECT_NEAR(again[k].distance, 1e-6 * hits[k].distance, 1e-18);
  }
}

}  // namespace
}  // namespace vasorod
