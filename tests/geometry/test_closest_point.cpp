#include <gtest/gtest.h>
#include <limits>
#include <random>

#include <vasorod/error.h>

#include "geometry/closest_point.h"
#include "geometry/noisy_tube.h"
#include "geometry/triangle_surface.h"

namespace vasorod {
namespace {

TriangleSurface cube() {
  TriangleSurface s;
  s.points.resize(8, 3);
  s.points << 0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 0, 1, 1, 0, 1, 0, 1, 1, 1, 1, 1;
  s.triangles.resize(12, 3);
  s.triangles << 0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4, 2, 6, 3, 3, 6, 7, 0, 4, 2, 2,
      4, 6, 1, 3, 5, 3, 7, 5;
  return s;
}

TEST(ClosestPoint, DistanceToACubeIsExactOnEverySideOfItsFacesEdgesAndCorners) {
  const ClosestPoint closest(cube());
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(-1, 2);
  for (int i = 0; i < 2000; ++i) {
    const Vec3 p(uniform(random), uniform(random), uniform(random));
    const Vec3 clamped = p.cwiseMax(0).cwiseMin(1);
    double expected = (p - clamped).norm();
    if (expected == 0) expected = -std::min(p.minCoeff(), (Vec3::Ones() - p).minCoeff());
    const auto hit = closest.query(p);
    EXPECT_NEAR(hit.signed_distance, expected, 1e-12);
    EXPECT_FALSE(hit.on_boundary);
    EXPECT_NEAR(hit.normal.norm(), 1, 1e-12);
    EXPECT_NEAR(hit.barycentric.sum(), 1, 1e-12);
  }
}

TEST(ClosestPoint, FindsWhatTryingEveryTriangleFinds) {
  testing::TubeShape shape;
  shape.bend = 1.2;
  shape.jitter = 0.25;
  auto tube = testing::noisy_tube(shape);
  ClosestPoint closest(tube);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(-15, 45);
  for (int round = 0; round < 2; ++round) {
    for (int i = 0; i < 200; ++i) {
      const Vec3 p(uniform(random), uniform(random), uniform(random));
      double best = std::numeric_limits<double>::infinity();
      for (int t = 0; t < tube.triangles.rows(); ++t) {
        const Vec3 a = tube.points.row(tube.triangles(t, 0)),
                   b = tube.points.row(tube.triangles(t, 1)),
                   c = tube.points.row(tube.triangles(t, 2));
        const Vec3 w = closest_in_triangle(p, a, b, c);
        best = std::min(best, (p - w[0] * a - w[1] * b - w[2] * c).norm());
      }
      const auto hit = closest.query(p);
      EXPECT_NEAR(std::abs(hit.signed_distance), best, 1e-12 * (1 + best));
      EXPECT_NEAR((p - hit.point).norm(), best, 1e-12 * (1 + best));
      // Wherever the search begins.
      const auto same = closest.query(p, i % static_cast<int>(tube.triangles.rows()));
      EXPECT_EQ(same.triangle, hit.triangle);
      EXPECT_EQ(same.barycentric, hit.barycentric);
    }
    tube.points = (tube.points * 1.3).eval();
    tube.points.col(0) += 0.1 * tube.points.col(2);  // shears the normals, too
    closest.refit(tube.points);
  }
}

TEST(ClosestPoint, ClosestInTriangleBeatsEverySampleAlsoWhenDegenerate) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(-1, 1);
  auto draw = [&] { return Vec3(uniform(random), uniform(random), uniform(random)); };
  for (int i = 0; i < 300; ++i) {
    const Vec3 a = draw(), b = draw(), p = 2 * draw();
    const Vec3 c = i % 3 == 0 ? Vec3(0.3 * a + 0.7 * b)
                              : (i % 3 == 1 ? a : draw());  // a line, a segment, a triangle
    const Vec3 w = closest_in_triangle(p, a, b, c);
    ASSERT_TRUE(w.allFinite());
    EXPECT_GE(w.minCoeff(), 0);
    EXPECT_NEAR(w.sum(), 1, 1e-12);
    const double distance = (p - w[0] * a - w[1] * b - w[2] * c).norm();
    for (int u = 0; u <= 20; ++u)
      for (int v = 0; u + v <= 20; ++v) {
        const Vec3 sample = (u * a + v * b + (20 - u - v) * c) / 20;
        EXPECT_LE(distance, (p - sample).norm() + 1e-9);
      }
  }
}

TEST(ClosestPoint, SignAndRimOfAnOpenTube) {
  testing::TubeShape shape;
  shape.jitter = 0.2;
  const ClosestPoint closest(testing::noisy_tube(shape));
  EXPECT_GT(closest.query({6, 0, 20}).signed_distance, 0.9);
  EXPECT_LT(closest.query({3, 0, 20}).signed_distance, -1.9);
  EXPECT_FALSE(closest.query({3, 0, 20}).on_boundary);
  EXPECT_TRUE(closest.query({5, 0, 43}).on_boundary);
}

// Off faces, edges, corners and the rims of open ends.
TEST(ClosestPoint, OneQueryIsThatOfTheTree) {
  testing::TubeShape shape;
  shape.jitter = 0.25;
  const TriangleSurface tube = testing::noisy_tube(shape);
  const TriangleSurface box = cube();
  std::mt19937 random(9);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (const TriangleSurface* surface : {&tube, &box}) {
    const ClosestPoint closest(*surface);
    const Vec3 middle = surface->points.colwise().mean();
    const double size =
        (surface->points.rowwise() - middle.transpose()).rowwise().norm().maxCoeff();
    for (int i = 0; i < 200; ++i) {
      const Vec3 p = middle + 1.3 * size * Vec3(uniform(random), uniform(random), uniform(random));
      const ClosestPoint::Hit expected = closest.query(p), hit = closest_on(*surface, p);
      EXPECT_NEAR(hit.signed_distance, expected.signed_distance, 1e-12 * size);
      EXPECT_LT((hit.point - expected.point).norm(), 1e-12 * size);
      EXPECT_LT((hit.normal - expected.normal).norm(), 1e-9);
      EXPECT_EQ(hit.on_boundary, expected.on_boundary);
      Vec3 there = Vec3::Zero();
      for (int k = 0; k < 3; ++k)
        there += hit.barycentric[k] *
                 surface->points.row(surface->triangles(hit.triangle, k)).transpose();
      EXPECT_LT((hit.point - there).norm(), 1e-12 * size);
    }
  }
}

TEST(ClosestPoint, MovedItIsTheSurfaceThere) {
  testing::TubeShape shape;
  shape.jitter = 0.2;
  TriangleSurface surface = testing::noisy_tube(shape);
  const Points rest = surface.points;
  const ClosestPoint first(surface);
  surface.points.col(0) += 0.1 * surface.points.col(2).cwiseProduct(surface.points.col(1));
  const ClosestPoint moved = first.moved(surface.points), fresh(surface);
  EXPECT_EQ(moved.surface().points, surface.points);
  EXPECT_EQ(first.surface().points, rest);
  for (int v = 0; v < rest.rows(); v += 3) {
    const Vec3 place = surface.points.row(v) + 0.2 * surface.points.row(v).reverse();
    EXPECT_EQ(moved.query(place).triangle, fresh.query(place).triangle);
    EXPECT_EQ(moved.query(place).signed_distance, fresh.query(place).signed_distance);
    EXPECT_EQ(moved.query(place).on_boundary, fresh.query(place).on_boundary);
  }
}

TEST(ClosestPoint, BoundaryEdgesAreThoseOfTheLoops) {
  const TriangleSurface surface = testing::noisy_tube({});
  std::vector<std::array<int, 2>> expected;
  for (const std::vector<int>& loop : boundary_loops(surface.triangles))
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const auto [a, b] = std::minmax(loop[k], loop[(k + 1) % loop.size()]);
      expected.push_back({a, b});
    }
  std::sort(expected.begin(), expected.end());
  EXPECT_GT(expected.size(), 20U);
  EXPECT_EQ(ClosestPoint(surface).boundary_edges(), expected);
  EXPECT_TRUE(ClosestPoint(cube()).boundary_edges().empty());
}

TEST(ClosestPoint, ASurfaceWithoutTrianglesIsRefused) {
  EXPECT_THROW(closest_on(TriangleSurface{}, Vec3::Zero()), InputError);
  EXPECT_THROW(ClosestPoint(TriangleSurface{}), InputError);
}

}  // namespace
}  // namespace vasorod
