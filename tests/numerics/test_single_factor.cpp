#include <Eigen/Cholesky>
#include <Eigen/SparseCore>
#include <cholmod.h>
#include <gtest/gtest.h>
#include <random>

#include "numerics/single_factor.h"

namespace vasorod {
namespace {

// A grid's Laplacian with a random diagonal on top: supernodes of many widths.
Eigen::SparseMatrix<double> grid(int side) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> more(0.1, 1);
  std::vector<Eigen::Triplet<double>> entries;
  const auto couple = [&](int a, int b) {
    entries.emplace_back(a, a, 1);
    entries.emplace_back(b, b, 1);
    entries.emplace_back(a, b, -1);
    entries.emplace_back(b, a, -1);
  };
  for (int i = 0; i < side; ++i)
    for (int j = 0; j < side; ++j) {
      const int here = i * side + j;
      entries.emplace_back(here, here, more(random));
      if (i + 1 < side) couple(here, here + side);
      if (j + 1 < side) couple(here, here + 1);
    }
  Eigen::SparseMatrix<double> matrix(side * side, side * side);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

TEST(SingleFactor, SolvesAsADenseFactorUpToItsPrecision) {
  Eigen::SparseMatrix<double> matrix = grid(15);
  const auto n = static_cast<int>(matrix.rows());
  cholmod_common common;
  cholmod_start(&common);
  common.supernodal = CHOLMOD_SUPERNODAL;
  common.final_ll = 1;
  cholmod_sparse view{};
  view.nrow = view.ncol = static_cast<size_t>(n);
  view.nzmax = static_cast<size_t>(matrix.nonZeros());
  view.p = matrix.outerIndexPtr();
  view.i = matrix.innerIndexPtr();
  view.x = matrix.valuePtr();
  view.stype = -1;
  view.itype = CHOLMOD_INT;
  view.xtype = CHOLMOD_REAL;
  view.dtype = CHOLMOD_DOUBLE;
  view.sorted = view.packed = 1;
  cholmod_factor* factor = cholmod_analyze(&view, &common);
  cholmod_factorize(&view, factor, &common);
  ASSERT_EQ(common.status, CHOLMOD_OK);
  ASSERT_TRUE(factor->is_super);
  ASSERT_GT(factor->nsuper, 1u);
  SingleFactor single(*factor);
  cholmod_free_factor(&factor, &common);  // the copy needs it no more
  cholmod_finish(&common);

  const Eigen::MatrixXd dense(matrix);
  const Eigen::MatrixXd b = Eigen::MatrixXd::Random(n, 4);
  const Eigen::MatrixXd exact = dense.llt().solve(b);
  Eigen::MatrixXd x(n, 4);
  single.solve(b.data(), x.data(), 4);
  EXPECT_LT((x - exact).norm(), 1e-5 * exact.norm());
  EXPECT_GT((x - exact).norm(), 1e-9 * exact.norm()) << "double precision would be another class";

  // One column after four, in place, and the same as among the four.
  Eigen::VectorXd one = b.col(2);
  single.solve(one.data(), one.data(), 1);
  EXPECT_EQ(one, x.col(2));

  // As a preconditioner must be: symmetric up to rounding, positive.
  Eigen::MatrixXd inverse(n, n);
  const Eigen::MatrixXd identity = Eigen::MatrixXd::Identity(n, n);
  single.solve(identity.data(), inverse.data(), n);
  EXPECT_LT((inverse - inverse.transpose()).norm(), 1e-5 * inverse.norm());
  EXPECT_EQ(Eigen::MatrixXd(0.5 * (inverse + inverse.transpose())).llt().info(), Eigen::Success);
}

}  // namespace
}  // namespace vasorod
