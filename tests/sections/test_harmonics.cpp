#include <gtest/gtest.h>

#include "sections/harmonics.h"

namespace vasorod {
namespace {

TEST(Harmonics, TheirDerivativesMatchDifferences) {
  const Eigen::VectorXd angles = Eigen::VectorXd::LinSpaced(7, -2, 5);
  const double h = 1e-5;
  const Eigen::VectorXd before = angles.array() - h, after = angles.array() + h;
  for (int order = 0; order < 2; ++order) {
    const Eigen::MatrixXd differences =
        (harmonic_values(after, 5, order) - harmonic_values(before, 5, order)) / (2 * h);
    EXPECT_LT((differences - harmonic_values(angles, 5, order + 1)).cwiseAbs().maxCoeff(), 1e-7);
  }
}

TEST(Harmonics, TheFirstThreeAreOneCosineAndSine) {
  const Eigen::MatrixXd values = harmonic_values(Eigen::VectorXd::Constant(1, 0.4), 1, 0);
  EXPECT_EQ(values(0, 0), 1);
  EXPECT_NEAR(values(0, 1), std::cos(0.4), 1e-15);
  EXPECT_NEAR(values(0, 2), std::sin(0.4), 1e-15);
}

}  // namespace
}  // namespace vasorod
