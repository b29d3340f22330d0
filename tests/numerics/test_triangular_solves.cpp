#include <Eigen/Cholesky>
#include <gtest/gtest.h>

#include "numerics/analysed_grid.h"
#include "numerics/fronts.h"
#include "numerics/triangular_solves.h"

namespace vasorod {
namespace {

using namespace testing;

struct Factored : AnalysedGrid {
  explicit Factored(int side) : AnalysedGrid(side), values(nodes.entries()) {
    Fronts<double>(nodes).factorise(analysis.in_order(matrix), values.data(), 1);
    single.assign(values.begin(), values.end());
  }
  std::vector<double> values;
  std::vector<float> single;
};

TEST(TriangularSolves, SolveAsADenseFactorInBothPrecisions) {
  const Factored a(15);
  const int n = a.nodes.unknowns();
  const Eigen::MatrixXd b = Eigen::MatrixXd::Random(n, 4),
                        exact = Eigen::MatrixXd(a.matrix).llt().solve(b);
  Eigen::MatrixXd x(n, 4);
  TriangularSolves<double> solves;
  solves.solve(a.nodes, a.values.data(), b.data(), x.data(), 4, 1);
  EXPECT_LT((x - exact).norm(), 1e-13 * exact.norm());
  TriangularSolves<float> single;
  single.solve(a.nodes, a.single.data(), b.data(), x.data(), 4, 1);
  EXPECT_LT((x - exact).norm(), 1e-5 * exact.norm());
  EXPECT_GT((x - exact).norm(), 1e-9 * exact.norm()) << "it is half the data";

  // One column after four, in place.
  Eigen::VectorXd one = b.col(2);
  solves.solve(a.nodes, a.values.data(), one.data(), one.data(), 1, 1);
  EXPECT_LT((one - exact.col(2)).norm(), 1e-13 * exact.col(2).norm());
}

// As a preconditioner must be: symmetric up to rounding, positive.
TEST(TriangularSolves, SinglePrecisionIsSymmetricAndPositive) {
  const Factored a(12);
  const int n = a.nodes.unknowns();
  Eigen::MatrixXd inverse(n, n);
  const Eigen::MatrixXd identity = Eigen::MatrixXd::Identity(n, n);
  TriangularSolves<float> single;
  single.solve(a.nodes, a.single.data(), identity.data(), inverse.data(), n, 1);
  EXPECT_LT((inverse - inverse.transpose()).norm(), 1e-5 * inverse.norm());
  EXPECT_EQ(Eigen::MatrixXd(0.5 * (inverse + inverse.transpose())).llt().info(), Eigen::Success);
}

TEST(TriangularSolves, ThreadsDoNotChangeABit) {
  const Factored a(60);  // blocks of several pieces
  const int n = a.nodes.unknowns();
  for (const int columns : {1, 3}) {
    const Eigen::MatrixXd b = Eigen::MatrixXd::Random(n, columns);
    Eigen::MatrixXd alone(n, columns), x(n, columns);
    TriangularSolves<double> solves;
    solves.solve(a.nodes, a.values.data(), b.data(), alone.data(), columns, 1);
    for (const int count : {2, 7}) {
      solves.solve(a.nodes, a.values.data(), b.data(), x.data(), columns, count);
      EXPECT_EQ(x, alone) << count << " threads, " << columns << " columns";
    }
  }
}

}  // namespace
}  // namespace vasorod
