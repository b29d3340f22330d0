#include <gtest/gtest.h>

#include "sections/lumen_point.h"
#include "some_tube.h"

namespace vasorod {
namespace {

using testing::disturbed, testing::straight_shape;

const SectionSpace space{3, AxialBasis(5, 3)};

Mat3 some_jet() {
  const SectionShape shape = disturbed(straight_shape(space, 1.1, 4.2), 0.07);
  const SurfaceJet jet = shape.jet(0.37, 1.1);
  Mat3 vectors;
  vectors << shape.point(0.37, 1.1), jet.col(0), jet.col(1);
  return vectors;
}

TEST(LumenPoint, DerivativesMatchDifferences) {
  for (const double thinning : {0.0, 0.4, 1.0, 2.5}) {
    const LumenPoint point(4, 0.2, thinning, 0.3);
    const Mat3 jet = some_jet();
    const PointVolume at = point.volume(jet, true);
    const double h = 1e-5;
    for (int k = 0; k < 9; ++k) {
      Mat3 before = jet, after = jet;
      before(k % 3, k / 3) -= h;
      after(k % 3, k / 3) += h;
      const PointVolume low = point.volume(before, false), high = point.volume(after, false);
      EXPECT_NEAR((high.value - low.value) / (2 * h), at.gradient(k % 3, k / 3), 1e-9);
      const Eigen::Matrix<double, 9, 1> change =
          ((high.gradient - low.gradient) / (2 * h)).reshaped();
      EXPECT_LT((change - at.hessian.col(k)).norm(), 1e-8) << thinning << " " << k;
    }
  }
}

TEST(LumenPoint, ATurnAboutTheOriginChangesNothing) {
  const LumenPoint point(4, 0.2, 0.4, 0.3);
  const Mat3 jet = some_jet(), turn = exp_rotation(Vec3(0.7, -1.2, 0.4));
  EXPECT_NEAR(point.volume(turn * jet, false).value, point.volume(jet, false).value, 1e-14);
}

TEST(LumenPoint, IsAShareOfTheConeLessTheTissue) {
  // On a cylinder of radius 2, per du dtheta: R^2 L / 3 - h R L (A / A_0)^m.
  Mat3 jet;
  jet << Vec3(2, 0, 7), Vec3(0, 0, 5), Vec3(0, 2, 0);
  EXPECT_NEAR(LumenPoint(10, 0.1, 0.4, 1).volume(jet, false).value, 20. / 3 - 1, 1e-14);
  EXPECT_NEAR(LumenPoint(5, 0.1, 0.4, 1).volume(jet, false).value, 20. / 3 - 0.5 * std::pow(2, 0.4),
              1e-14);
}

TEST(LumenPoint, APointCollapsedToALineStaysFinite) {
  Mat3 jet;
  jet << Vec3(2, 0, 7), Vec3(0, 0, 5), Vec3(0, 0, 2);
  const PointVolume volume = LumenPoint(10, 0.1, 0.4, 1).volume(jet, true);
  EXPECT_TRUE(std::isfinite(volume.value));
  EXPECT_TRUE(volume.gradient.allFinite());
  EXPECT_TRUE(volume.hessian.allFinite());
}

}  // namespace
}  // namespace vasorod
