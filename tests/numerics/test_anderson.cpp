#include <Eigen/LU>
#include <gtest/gtest.h>
#include <random>

#include "numerics/anderson.h"

namespace vasorod {
namespace {

using Eigen::MatrixXd, Eigen::VectorXd;

MatrixXd random_matrix(int size, unsigned seed) {
  std::mt19937 engine(seed);
  std::normal_distribution<double> normal;
  return MatrixXd::NullaryExpr(size, size, [&] { return normal(engine); });
}

// f = b - A x of a matrix on which x <- x + f diverges: as many steps as it has unknowns, and one.
TEST(Anderson, SolvesALinearSystem) {
  for (const int size : {1, 5, 12}) {
    const MatrixXd a = 3 * MatrixXd::Identity(size, size) + random_matrix(size, 2) / 4;
    const VectorXd b = random_matrix(size, 3).col(0), exact = a.lu().solve(b);
    Anderson accelerated(size);
    VectorXd x = VectorXd::Zero(size), plain = x;
    for (int step = 0; step < size + 2; ++step) {
      x = accelerated.next(x, b - a * x);
      plain += b - a * plain;
    }
    EXPECT_LT((x - exact).norm(), 1e-9 * exact.norm()) << size;
    EXPECT_GT((plain - exact).norm(), exact.norm()) << size;
    // There, where nothing changes any more, it stays.
    for (int step = 0; step < 3; ++step) x = accelerated.next(x, b - a * x);
    EXPECT_LT((x - exact).norm(), 1e-9 * exact.norm()) << size;
  }
}

TEST(Anderson, RemembersNoMoreThanItsDepth) {
  const MatrixXd a = MatrixXd::Identity(8, 8) + random_matrix(8, 4) / 12;
  const VectorXd b = random_matrix(8, 5).col(0), exact = a.lu().solve(b);
  const auto error_after = [&](int depth, int steps) {
    Anderson accelerated(depth);
    VectorXd x = VectorXd::Zero(8);
    for (int step = 0; step < steps; ++step) x = accelerated.next(x, b - a * x);
    return (x - exact).norm() / exact.norm();
  };
  EXPECT_LT(error_after(8, 10), 1e-9);
  EXPECT_GT(error_after(1, 10), 1e-9);
  EXPECT_LT(error_after(1, 60), 1e-9);
}

}  // namespace
}  // namespace vasorod
