#include <gtest/gtest.h>

#include "some_tube.h"

namespace vasorod {
namespace {

using testing::disturbed, testing::straight_shape;

const SectionSpace space{3, AxialBasis(6, 3)};

TEST(SectionShape, ItsJetMatchesDifferences) {
  const SectionShape shape = disturbed(straight_shape(space, 1, 6), 0.1);
  const double h = 1e-4, u = 0.43, a = 0.9;
  const auto x = [&](double du, double da) { return shape.point(u + du, a + da); };
  const SurfaceJet jet = shape.jet(u, a);
  EXPECT_LT((jet.col(0) - (x(h, 0) - x(-h, 0)) / (2 * h)).norm(), 1e-5);
  EXPECT_LT((jet.col(1) - (x(0, h) - x(0, -h)) / (2 * h)).norm(), 1e-6);
  EXPECT_LT((jet.col(2) - (x(h, 0) - 2 * x(0, 0) + x(-h, 0)) / (h * h)).norm(), 1e-4);
  EXPECT_LT((jet.col(3) - (x(h, h) - x(h, -h) - x(-h, h) + x(-h, -h)) / (4 * h * h)).norm(), 1e-5);
  EXPECT_LT((jet.col(4) - (x(0, h) - 2 * x(0, 0) + x(0, -h)) / (h * h)).norm(), 1e-5);
}

TEST(SectionShape, IsTheSameInASpaceThatContainsIt) {
  const SectionShape shape = disturbed(straight_shape({3, AxialBasis(1, 3)}, 1, 6), 0.1);
  const SectionShape finer = in_space(shape, {5, AxialBasis(9, 3)});
  for (const double u : {0.0, 0.2, 0.71, 1.0})
    for (const double a : {0.1, 2.0, 4.5})
      EXPECT_LT((shape.point(u, a) - finer.point(u, a)).norm(), 1e-12);
}

TEST(SectionShape, ATubesFrameIsItsNormalItsRoundAndItsAxis) {
  const Mat3 frame = surface_frame(straight_shape(space, 2, 6).jet(0.3, 0));
  EXPECT_LT((frame - Mat3::Identity()).norm(), 1e-14);
}

}  // namespace
}  // namespace vasorod
