#include <Eigen/Core>
#include <gtest/gtest.h>

#include "numerics/kept_factor.h"

namespace vasorod {
namespace {

Eigen::SparseMatrix<double> chain(int n, double diagonal) {
  Eigen::SparseMatrix<double> m(n, n);
  for (int i = 0; i < n; ++i) {
    m.insert(i, i) = diagonal;
    if (i > 0) m.insert(i, i - 1) = m.insert(i - 1, i) = -1;
  }
  m.makeCompressed();
  return m;
}

double misfit(KeptFactor& factor, const Eigen::SparseMatrix<double>& m) {
  const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(m.rows(), -1, 2);
  Eigen::VectorXd x(m.rows());
  factor.solve(b.data(), x.data(), 1);
  return (m * x - b).cwiseAbs().maxCoeff();
}

// The matrix that could not be factorised is not taken for the factor's.
TEST(KeptFactor, StoppedItFactorisesTheSameMatrixAnew) {
  constexpr int n = 200;
  Eigen::SparseMatrix<double> dense(n, n);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; j += 1 + (i + j) % 7 * (i != j)) dense.coeffRef(i, j) = 1;
  Eigen::SparseMatrix<double> m = dense.transpose() * dense;
  for (int i = 0; i < n; ++i) m.coeffRef(i, i) += n;
  KeptFactor factor;
  EXPECT_THROW(factor.factorise(m, [] { return true; }), Interruption);
  ASSERT_TRUE(factor.factorise(m));
  EXPECT_EQ(factor.factorisations(), 2);
  EXPECT_LT(misfit(factor, m), 1e-8);
}

TEST(KeptFactor, IsRenewedOnlyWhereTheMatrixHasChanged) {
  KeptFactor factor;
  for (const double diagonal : {2.5, 2.5, 3.0}) {
    ASSERT_TRUE(factor.factorise(chain(9, diagonal)));
    EXPECT_LT(misfit(factor, chain(9, diagonal)), 1e-14);
  }
  EXPECT_EQ(factor.factorisations(), 2);
  ASSERT_TRUE(factor.factorise(chain(12, 3.0)));  // another pattern
  EXPECT_LT(misfit(factor, chain(12, 3.0)), 1e-14);
  EXPECT_EQ(factor.factorisations(), 3);
}

TEST(KeptFactor, IsInSinglePrecisionWhereARoughOneIsAskedFor) {
  KeptFactor factor(nullptr, Precision::rough);
  for (const double diagonal : {2.5, 2.5, 3.0}) {
    ASSERT_TRUE(factor.factorise(chain(9, diagonal)));
    const double left = misfit(factor, chain(9, diagonal));
    EXPECT_LT(left, 1e-5);
    EXPECT_GT(left, 1e-12);
  }
  EXPECT_EQ(factor.factorisations(), 2);
}

TEST(KeptFactor, AFailedFactorIsTriedAgain) {
  KeptFactor factor;
  EXPECT_FALSE(factor.factorise(chain(9, 0.5)));
  EXPECT_FALSE(factor.factorise(chain(9, 0.5)));
  EXPECT_TRUE(factor.factorise(chain(9, 2.5)));
  EXPECT_LT(misfit(factor, chain(9, 2.5)), 1e-14);
}

}  // namespace
}  // namespace vasorod
