// The strip laid around an elliptic hole.
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "reference_fem/hole_chart.h"

namespace vasorod::fem {
namespace {

constexpr double pi = std::numbers::pi;

HoleChart hole_of(double half_length, double half_width) {
  return {half_length, half_width, 0.45, 12, 3.2};
}

TEST(HoleChart, TheRimHasAnEvenPace) {
  for (const auto& [a, b] : {std::pair{1.5, 0.4}, {0.7, 0.7}, {0.5, 1.1}}) {
    const HoleChart hole = hole_of(a, b);
    // lengths of chords of a fine polygon
    double length = 0, largest = 0, smallest = 1e300;
    const int n = 2000;
    for (int k = 0; k < n; ++k) {
      const Vec2 p = hole.rim(static_cast<double>(k) / n),
                 q = hole.rim(static_cast<double>(k + 1) / n);
      EXPECT_NEAR(std::pow(p[0] / a, 2) + std::pow(p[1] / b, 2), 1, 1e-12);
      length += (q - p).norm();
      largest = std::max(largest, (q - p).norm());
      smallest = std::min(smallest, (q - p).norm());
    }
    EXPECT_NEAR(4 * length / hole.perimeter(), 1, 1e-6);
    EXPECT_LT(largest / smallest - 1, 1e-4);
    EXPECT_EQ(hole.rim(0)[0], a);
    EXPECT_EQ(hole.rim(1)[1], b);
  }
  EXPECT_NEAR(hole_of(0.7, 0.7).perimeter(), 1.4 * pi, 1e-12);
}

// The strip between the tips becomes the rim, its other edges stay, and no cell is turned over: the
// area left is the wall's without the ellipse.
TEST(HoleChart, FillsTheWallAroundTheHole) {
  const HoleChart hole = hole_of(1.5, 0.8);
  EXPECT_LT((hole.place(0.5, 0.3) - Vec2(0.5, hole.place(0.5, 0.3)[1])).norm(), 1e-12);
  EXPECT_LT((hole.place(0, 1) - Vec2(0, 1)).norm(), 1e-12);
  EXPECT_LT((hole.place(0.2, 0) - Vec2(0.2, 0)).norm(), 1e-12);
  EXPECT_LT((hole.place(0, 0.45 + 1.5 / 12) - Vec2(0, 0.45 + 1.5 / 12)).norm(), 1e-12);
  EXPECT_LT((hole.place(0, 0.45) - Vec2(0.8 / 6.4, 0.45)).norm(), 1e-12);
  EXPECT_LT((hole.place(1, 0.45) - Vec2(1 - 0.8 / 6.4, 0.45)).norm(), 1e-12);
  const int n = 400;
  double area = 0, smallest = 1e300;
  const auto at = [&](int i, int j) {
    const Vec2 p = hole.place(static_cast<double>(i) / n, static_cast<double>(j) / n);
    return Vec2(6.4 * p[0], 12 * p[1]);
  };
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const Vec2 d = at(i + 1, j + 1) - at(i, j), e = at(i, j + 1) - at(i + 1, j);
      const double cell = 0.5 * (d[0] * e[1] - d[1] * e[0]);
      area += cell;
      smallest = std::min(smallest, cell);
    }
  EXPECT_GT(smallest, 0);
  EXPECT_NEAR(area, 12 * 6.4 - pi * 1.5 * 0.8, 2e-3);
}

}  // namespace
}  // namespace vasorod::fem
