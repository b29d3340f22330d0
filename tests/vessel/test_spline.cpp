#include <gtest/gtest.h>
#include <random>

#include <vasorod/types.h>

#include "vessel/arc_length.h"
#include "vessel/spline.h"

namespace vasorod {
namespace {

// A curve that turns and whose parameter runs unevenly.
Spline<3> some_curve() {
  Spline<3> curve;
  curve.start = -1.5;
  curve.end = 4;
  curve.intervals = 7;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> aside(-0.3, 0.3);
  for (int k = 0; k < curve.intervals + 3; ++k)
    curve.control.emplace_back(k + aside(random), aside(random), aside(random));
  return curve;
}

TEST(Spline, DerivativesAreThoseOfItsValues) {
  const Spline<3> curve = some_curve();
  const double h = 1e-4;
  for (double u = curve.start + 0.01; u < curve.end - 0.01; u += 0.0371) {
    const auto [value, first, second] = curve.jet(u);
    EXPECT_EQ(value, curve(u));
    EXPECT_EQ(first, curve.derivative(u));
    EXPECT_EQ(second, curve.second(u));
    EXPECT_LT((first - (curve(u + h) - curve(u - h)) / (2 * h)).norm(), 1e-7);
    // Where a knot lies in between, the third derivative jumps.
    EXPECT_LT((second - (curve.derivative(u + h) - curve.derivative(u - h)) / (2 * h)).norm(),
              5 * h);
  }
}

TEST(Spline, GoesOnStraightBeyondItsEnds) {
  const Spline<3> curve = some_curve();
  for (const double end : {curve.start, curve.end})
    for (const double beyond : {1e-9, 0.3, 20.0}) {
      const double u = end == curve.start ? end - beyond : end + beyond;
      EXPECT_LT((curve(u) - curve(end) - (u - end) * curve.derivative(end)).norm(), 1e-12);
      EXPECT_EQ(curve.derivative(u), curve.derivative(end));
      EXPECT_EQ(curve.second(u), Vec3::Zero());
    }
}

TEST(ArcLength, IsThatOfAFinePolygon) {
  const Spline<3> curve = some_curve();
  const ArcLength arc(curve);
  EXPECT_EQ(arc(curve.start), 0);
  double length = 0, u = curve.start;
  constexpr int pieces = 100000;
  for (int k = 1; k <= pieces; ++k) {
    const double next = curve.start + (curve.end - curve.start) * k / pieces;
    length += (curve(next) - curve(u)).norm();
    u = next;
    if (k % 997 == 0 || k == pieces) {
      EXPECT_NEAR(arc(u), length, 1e-6) << u;
    }
  }
  for (const double share : {0.01, 0.4, 0.99})
    EXPECT_NEAR(arc(arc.inverse(share * length)), share * length, 1e-12);
}

TEST(ArcLength, GrowsEvenlyBeyondTheEnds) {
  const Spline<3> curve = some_curve();
  const ArcLength arc(curve);
  for (const double beyond : {1e-9, 0.3, 20.0}) {
    const double before = (curve(curve.start - beyond) - curve(curve.start)).norm(),
                 after = (curve(curve.end + beyond) - curve(curve.end)).norm();
    EXPECT_NEAR(arc(curve.start - beyond), -before, 1e-12);
    EXPECT_NEAR(arc(curve.end + beyond), arc(curve.end) + after, 1e-12);
  }
}

}  // namespace
}  // namespace vasorod
