#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>

#include "bodies/feature_distance.h"
#include "paper/paper_tubes.h"

namespace vasorod {
namespace {

using namespace testing;

FeatureCorners corners_of(const Points& p) {
  return {p.row(0), p.row(1), p.row(2), p.row(3)};
}

// The smallest distance between points of the two features on a grid.
double by_grid(const FeatureCorners& x, Features features) {
  constexpr int n = 200;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j) {
      const double s = static_cast<double>(i) / n, t = static_cast<double>(j) / n;
      if (features == Features::two_edges)
        least = std::min(least, (x[0] + s * (x[1] - x[0]) - x[2] - t * (x[3] - x[2])).norm());
      else if (i + j <= n)
        least = std::min(least, (x[0] - x[1] - s * (x[2] - x[1]) - t * (x[3] - x[1])).norm());
    }
  return least;
}

TEST(FeatureDistance, IsTheSmallestOfAllPointsOfTheTwo) {
  for (unsigned seed = 1; seed < 60; ++seed)
    for (const Features features : {Features::two_edges, Features::vertex_and_triangle}) {
      const FeatureCorners x = corners_of(random_points(4, seed));
      const FeatureDistance found = feature_distance(x, features);
      EXPECT_NEAR(found.distance, by_grid(x, features), 0.01);
      EXPECT_LE(found.distance, by_grid(x, features) + 1e-12);
      EXPECT_NEAR(found.apart.norm(), found.distance, 1e-15);
    }
}

TEST(FeatureDistance, OfKnownPlaces) {
  const FeatureCorners above{Vec3(0.2, 0.3, 0.7), Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
  const FeatureDistance face = feature_distance(above, Features::vertex_and_triangle);
  EXPECT_NEAR(face.distance, 0.7, 1e-15);
  EXPECT_NEAR(face.weight[1], -0.5, 1e-15);
  const FeatureCorners crossing{Vec3(-1, 0, 0.4), Vec3(1, 0, 0.4), Vec3(0, -1, 0), Vec3(0, 3, 0)};
  const FeatureDistance edges = feature_distance(crossing, Features::two_edges);
  EXPECT_NEAR(edges.distance, 0.4, 1e-15);
  EXPECT_NEAR(edges.weight[3], -0.25, 1e-15);
  // parallel, and beside each other along a stretch
  const FeatureCorners parallel{Vec3(0, 0, 0), Vec3(2, 0, 0), Vec3(1, 0, 0.5), Vec3(3, 0, 0.5)};
  EXPECT_NEAR(feature_distance(parallel, Features::two_edges).distance, 0.5, 1e-15);
}

// Every kind of closest point occurs among these: inside, on an edge, at a vertex.
TEST(FeatureDistance, ItsDerivativesAreThoseOfDifferences) {
  std::array<int, 3> kinds{};
  for (unsigned seed = 1; seed < 200; ++seed)
    for (const Features features : {Features::two_edges, Features::vertex_and_triangle}) {
      const Points p = random_points(4, seed);
      const FeatureDistance found = feature_distance(corners_of(p), features);
      const auto value = [&](const Points& at) {
        const double d = feature_distance(corners_of(at), features).distance;
        return d * d / 2;
      };
      const auto slope = [&](const Points& at) {
        const FeatureDistance there = feature_distance(corners_of(at), features);
        Points gradient(4, 3);
        for (int k = 0; k < 4; ++k)
          gradient.row(k) = there.weight[static_cast<size_t>(k)] * there.apart.transpose();
        return gradient;
      };
      EXPECT_LT(gradient_error(value, p, slope(p)), 1e-6) << seed;
      EXPECT_LT(hessian_error(slope, p, half_square_hessian(corners_of(p), found, features), 1e-6),
                1e-5)
          << seed;
      const auto zeros = std::count(found.weight.begin(), found.weight.end(), 0.0);
      ++kinds[static_cast<size_t>(std::min<long>(zeros, 2))];
    }
  for (const int kind : kinds) EXPECT_GT(kind, 10);
}

}  // namespace
}  // namespace vasorod
