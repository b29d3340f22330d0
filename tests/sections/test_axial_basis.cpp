#include <gtest/gtest.h>

#include "sections/axial_basis.h"

namespace vasorod {
namespace {

TEST(AxialBasis, SumsToOneAndItsDerivativesMatchDifferences) {
  const AxialBasis basis(7, 3);
  EXPECT_EQ(basis.count(), 10);
  EXPECT_EQ(basis.spans(), 7);
  for (const double u : {0.0, 0.013, 0.31, 0.5, 0.77, 1.0}) {
    const AxialBasis::Values at = basis.at(u);
    EXPECT_NEAR(at.values.row(0).sum(), 1, 1e-14);
    EXPECT_NEAR(at.values.row(1).sum(), 0, 1e-11);
    const double h = 1e-6, inside = std::clamp(u, h, 1 - h);
    const AxialBasis::Values middle = basis.at(inside), before = basis.at(inside - h),
                             after = basis.at(inside + h);
    if (before.first != after.first) continue;
    for (int order = 0; order < 2; ++order) {
      const Eigen::RowVectorXd difference =
          (after.values.row(order) - before.values.row(order)) / (2 * h);
      EXPECT_LT((difference - middle.values.row(order + 1)).norm(),
                1e-5 * (1 + middle.values.row(order + 1).norm()));
    }
  }
}

TEST(AxialBasis, ItsKnotsAreSymmetricAndDenserBesideTheEnds) {
  const AxialBasis basis(8, 3);
  EXPECT_DOUBLE_EQ(basis.begin(0), 0);
  EXPECT_DOUBLE_EQ(basis.end(7), 1);
  EXPECT_NEAR(basis.end(2), 1 - basis.begin(5), 1e-15);
  EXPECT_LT(basis.end(0) - basis.begin(0), 0.7 * (basis.end(3) - basis.begin(3)));
}

TEST(AxialBasis, TheFirstFunctionAloneIsOneAtTheStartAndTheSecondItsSlope) {
  const AxialBasis::Values start = AxialBasis(6, 3).at(0), end = AxialBasis(6, 3).at(1);
  EXPECT_NEAR(start.values(0, 0), 1, 1e-15);
  EXPECT_NEAR(start.values(1, 0), -start.values(1, 1), 1e-12);
  EXPECT_NEAR(start.values(1, 2), 0, 1e-12);
  EXPECT_NEAR(end.values(0, 3), 1, 1e-12);
  EXPECT_NEAR(end.values(1, 3), -end.values(1, 2), 1e-9);
}

}  // namespace
}  // namespace vasorod
