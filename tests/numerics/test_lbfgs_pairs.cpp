#include <cmath>
#include <gtest/gtest.h>

#include "numerics/lbfgs_pairs.h"

namespace vasorod {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int size = 6, memory = 4;

const Preconditioner halved = [](const VectorXd& g, VectorXd& d) { d = g / 2; };

// The gradient of a quadratic energy, whose Hessian is known.
VectorXd gradient_at(const VectorXd& x) {
  MatrixXd hessian = VectorXd::LinSpaced(size, 1, 4).asDiagonal();
  hessian += 0.3 * MatrixXd::Ones(size, size);
  return hessian * x;
}

// The BFGS update of an inverse Hessian, written out.
MatrixXd updated(const MatrixXd& inverse, const VectorXd& s, const VectorXd& y) {
  const double rho = 1 / s.dot(y);
  const MatrixXd left = MatrixXd::Identity(size, size) - rho * s * y.transpose();
  return left * inverse * left.transpose() + rho * s * s.transpose();
}

VectorXd step(int k) {
  VectorXd s(size);
  for (int i = 0; i < size; ++i) s[i] = std::sin(1.0 + 3 * k + 2 * i);
  return s;
}

class LbfgsPairsTest : public ::testing::Test {
 protected:
  LbfgsPairsTest() { pairs_.begin(size, memory); }

  VectorXd descend() {
    VectorXd direction(size);
    pairs_.descend(halved, gradient_at(x_), work_, direction);
    return direction;
  }
  void go(int k) {
    descend();  // as lbfgs() does before each step
    const VectorXd s = step(k), before = gradient_at(x_);
    x_ += s;
    pairs_.add(0.5, 2 * s, before, gradient_at(x_));
  }
  // With the pairs from `first` to before `end`.
  VectorXd expected(int first, int end) const {
    MatrixXd inverse = MatrixXd::Identity(size, size) / 2;
    for (int k = first; k < end; ++k) inverse = updated(inverse, step(k), gradient_at(step(k)));
    return -inverse * gradient_at(x_);
  }

  LbfgsPairs pairs_;
  VectorXd x_ = VectorXd::Ones(size), work_;
};

TEST_F(LbfgsPairsTest, TheDirectionIsThatOfTheUpdatedInverse) {
  EXPECT_LT((descend() - expected(0, 0)).norm(), 1e-14);
  for (int k = 0; k < memory; ++k) {
    go(k);
    EXPECT_LT((descend() - expected(0, k + 1)).norm(), 1e-12 * x_.norm()) << k;
  }
}

TEST_F(LbfgsPairsTest, TheOldestIsForgotten) {
  for (int k = 0; k < memory + 2; ++k) go(k);
  EXPECT_LT((descend() - expected(2, memory + 2)).norm(), 1e-12 * x_.norm());
}

// The next run may begin elsewhere, so that its first gradient is not the one after the last step.
TEST_F(LbfgsPairsTest, AnotherRunOfTheSameSizeGoesOnWithThem) {
  for (int k = 0; k < 3; ++k) go(k);
  pairs_.begin(size, memory);
  x_ = VectorXd::LinSpaced(size, -2, 3);
  EXPECT_LT((descend() - expected(0, 3)).norm(), 1e-12 * x_.norm());
}

TEST_F(LbfgsPairsTest, AnotherRunOfAnotherSizeHasNone) {
  go(0);
  pairs_.begin(size + 1, memory);
  EXPECT_TRUE(pairs_.empty());
}

TEST_F(LbfgsPairsTest, WhatCurvesDownwardsIsLeftOut) {
  descend();
  const VectorXd before = gradient_at(x_), s = step(0);
  pairs_.add(1, s, before, before - s);
  EXPECT_TRUE(pairs_.empty());
}

}  // namespace
}  // namespace vasorod
