#include <cmath>
#include <gtest/gtest.h>

#include "geometry/loops.h"

namespace vasorod {
namespace {

Points circle(int count, double radius, double start, int sense) {
  Points p(count, 3);
  for (int k = 0; k < count; ++k) {
    const double angle = start + sense * 2 * M_PI * k / count;
    p.row(k) << radius * std::cos(angle), radius * std::sin(angle), 0;
  }
  return p;
}

TEST(Loops, PositionsAndPointsOfARectangle) {
  Points p(4, 3);
  p << 0, 0, 0, 3, 0, 0, 3, 1, 0, 0, 1, 0;
  const LoopCurve loop(p);
  EXPECT_DOUBLE_EQ(loop.length(), 8);
  EXPECT_DOUBLE_EQ(loop.position(3), 7);
  EXPECT_NEAR((loop.at(3.5 / 8) - Vec3(3, 0.5, 0)).norm(), 0, 1e-14);
  EXPECT_NEAR((loop.at(-0.5 / 8) - Vec3(0, 0.5, 0)).norm(), 0, 1e-14);
  EXPECT_NEAR((loop.at(1) - Vec3(0, 0, 0)).norm(), 0, 1e-14);
}

TEST(Loops, AFractionIsAPlaceOnAnEdge) {
  Points p(4, 3);
  p << 0, 0, 0, 3, 0, 0, 3, 1, 0, 0, 1, 0;
  const LoopCurve loop(p);
  const auto expect_place = [&](double fraction, int edge, double along) {
    EXPECT_EQ(loop.place(fraction).edge, edge) << fraction;
    EXPECT_NEAR(loop.place(fraction).along, along, 1e-14) << fraction;
    EXPECT_NEAR((loop.at(loop.place(fraction)) - loop.at(fraction)).norm(), 0, 1e-15);
  };
  expect_place(1.5 / 8, 0, 0.5);
  expect_place(7.25 / 8, 3, 0.25);
  expect_place(-0.25 / 8, 3, 0.75);
  // Corners are met exactly, also if rounding is off.
  for (const double off : {-1e-15, 0.0, 1e-15}) {
    EXPECT_EQ(loop.place(3.0 / 8 + off).along, 0);
    expect_place(3.0 / 8 + off, 1, 0);
    expect_place(1 + off, 0, 0);
  }
}

TEST(Loops, TheOffsetOfTwoCirclesIsTheirAngle) {
  for (const double turn : {0.3, 1.7, 4.0}) {
    const LoopCurve a(circle(64, 2, 0, +1)), b(circle(80, 2.5, turn, -1));
    const double offset = opposite_offset(a, b);
    // b starts at angle `turn` and has the opposite orientation: it is at angle 2 pi u where
    // w = turn / (2 pi) - u.
    EXPECT_NEAR(std::remainder(offset - turn / (2 * M_PI), 1.0), 0, 2e-4);  // both are polygons
    EXPECT_NEAR(opposite_distance(a, b, offset), 0.25, 1e-3);
  }
}

TEST(Loops, TheDistanceIsTheMeanOfManySamples) {
  Points triangle(3, 3);
  triangle << 0, 0, 0, 2, 0, 1, 0.3, 1.5, 0;
  const LoopCurve a(circle(7, 1.2, 0.4, +1)), b(triangle);
  for (const double offset : {0.0, 0.31, 0.8}) {
    constexpr int samples = 100000;
    double sum = 0;
    for (int i = 0; i < samples; ++i) {
      const double u = (i + 0.5) / samples;
      sum += (a.at(u) - b.at(offset - u)).squaredNorm() / samples;
    }
    EXPECT_NEAR(opposite_distance(a, b, offset), sum, 1e-8);
  }
}

TEST(Loops, NoOtherOffsetLiesCloser) {
  Points slit(20, 3);  // a flat slit, both banks on each other
  for (int k = 0; k < 20; ++k) slit.row(k) << (k <= 10 ? k - 5.0 : 15.0 - k), 0, 0;
  const LoopCurve a(circle(33, 20 / (2 * M_PI), 0.7, +1)), b(slit);
  const double offset = opposite_offset(a, b), least = opposite_distance(a, b, offset);
  for (int k = 0; k < 1000; ++k) EXPECT_GE(opposite_distance(a, b, k / 1000.0), least - 1e-12);
}

}  // namespace
}  // namespace vasorod
