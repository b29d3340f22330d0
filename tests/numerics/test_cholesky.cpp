#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>
#include <numeric>
#include <thread>

#include "numerics/blas.h"
#include "numerics/cholesky.h"
#include "paper/paper_tubes.h"

namespace vasorod {
namespace {

using namespace testing;
using Matrix = Eigen::SparseMatrix<double>;

Matrix random_positive(int n, unsigned seed, double shift) {
  const Points p = random_points(n, seed);
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < n; ++i) {
    entries.emplace_back(i, i, 4 + shift);
    for (int k = 0; k < 3; ++k) {
      const int j = static_cast<int>(std::abs(p(i, k)) * n) % n;
      if (j == i) continue;
      entries.emplace_back(i, j, p(i, k) / 4);
      entries.emplace_back(j, i, p(i, k) / 4);
    }
  }
  Matrix m(n, n);
  m.setFromTriplets(entries.begin(), entries.end());
  return m;
}

TEST(Cholesky, SolvesThreeRightHandSidesAsADenseSolverDoes) {
  const Matrix a = random_positive(60, 1, 0), b = random_positive(60, 1, 2);
  const Eigen::MatrixXd rhs = random_points(60, 2);
  Cholesky cholesky;
  cholesky.analyse(a);
  for (const Matrix& m : {a, b}) {  // the second reuses the analysis
    ASSERT_TRUE(cholesky.factorise(m));
    Eigen::MatrixXd x(60, 3);
    cholesky.solve(rhs.data(), x.data(), 3);
    EXPECT_TRUE(x.isApprox(Eigen::MatrixXd(m).ldlt().solve(rhs), 1e-12));
  }
}

// A chain eliminated from one end has no fill: the factor has its diagonal and one entry per link.
TEST(Cholesky, CountsFactorisationsThatFailSolvesAndEntries) {
  constexpr int n = 50;
  std::vector<Eigen::Triplet<double>> entries;
  std::vector<int> along(n);
  for (int i = 0; i < n; ++i) {
    along[static_cast<size_t>(i)] = i;
    entries.emplace_back(i, i, 3);
    if (i > 0) entries.emplace_back(i, i - 1, 1);
  }
  Matrix good(n, n), bad(n, n);
  good.setFromTriplets(entries.begin(), entries.end());
  bad = good;
  bad.coeffRef(n / 2, n / 2) = -3;
  Work work;
  Cholesky cholesky(&work);
  cholesky.analyse(good, along);
  EXPECT_EQ(work.counts, Counts{}) << "nothing is factorised yet";
  EXPECT_FALSE(cholesky.factorise(bad));
  EXPECT_TRUE(cholesky.factorise(good));
  const Eigen::MatrixXd rhs = random_points(n, 2);
  Eigen::MatrixXd x(n, 3);
  cholesky.solve(rhs.data(), x.data(), 3);
  EXPECT_EQ(work.counts, (Counts{.factorisations = 2, .solves = 1, .factor_nonzeros = 2 * n - 1}));
  cholesky.precondition(rhs.data(), x.data(), 3);  // also compared with a solve in double precision
  EXPECT_EQ(work.counts.solves, 3);
  cholesky.precondition(rhs.data(), x.data(), 3);
  EXPECT_EQ(work.counts.solves, 4);
  EXPECT_GT(work.factor_seconds, 0) << "it is measured; how long is not tested";
}

TEST(Cholesky, HasNoFactorWhereItWasStoppedAndOneAfterwards) {
  const Matrix a = random_positive(900, 1, 0);
  Work work;
  Cholesky cholesky(&work);
  cholesky.analyse(a);
  ASSERT_TRUE(cholesky.factorise(a));
  int asked = 0;
  EXPECT_THROW(cholesky.factorise(a, [&] { return ++asked == 2; }), Interruption);
  EXPECT_EQ(asked, 2);
  EXPECT_FALSE(cholesky.factorised());
  ASSERT_TRUE(cholesky.factorise(a, [] { return false; }));
  EXPECT_TRUE(cholesky.factorised());
  EXPECT_EQ(work.counts.factorisations, 3);
  const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(a.rows(), -1, 2);
  Eigen::VectorXd x(a.rows());
  cholesky.solve(b.data(), x.data(), 1);
  EXPECT_LT((a * x - b).norm(), 1e-12 * b.norm());
}

// In single precision: close to the exact solution, symmetric and positive.
TEST(Cholesky, PreconditionsAlmostAsItSolves) {
  const Matrix a = random_positive(400, 1, 0);
  const Eigen::MatrixXd rhs = random_points(400, 2);
  Cholesky cholesky;
  cholesky.analyse(a);
  ASSERT_TRUE(cholesky.factorise(a));
  Eigen::MatrixXd exact(400, 3), x(400, 3);
  cholesky.solve(rhs.data(), exact.data(), 3);
  cholesky.precondition(rhs.data(), x.data(), 3);
  EXPECT_NE(x, exact);
  EXPECT_TRUE(x.isApprox(exact, 1e-6));
  const Eigen::Matrix3d products = rhs.transpose() * x;
  EXPECT_TRUE(products.isApprox(products.transpose(), 1e-5));
  EXPECT_GT(products.diagonal().minCoeff(), 0);
  Eigen::VectorXd alone(400);
  cholesky.precondition(rhs.data(), alone.data(), 1);
  EXPECT_TRUE(alone.isApprox(x.col(0), 1e-6)) << "the BLAS sums one column in another order";
}

// A clamped beam of 3,000 finite differences, condition 1e13: single precision would solve a
// different beam.
Matrix long_beam() {
  constexpr int n = 3000;
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < n; ++i)
    for (const auto& [away, value] : {std::pair{0, 6.0}, {1, -4.0}, {2, 1.0}}) {
      if (i + away >= n) continue;
      entries.emplace_back(i, i + away, value);
      if (away > 0) entries.emplace_back(i + away, i, value);
    }
  Matrix m(n, n);
  m.setFromTriplets(entries.begin(), entries.end());
  return m;
}

TEST(Cholesky, PreconditionsInDoublePrecisionWhereSingleWillNotDo) {
  const Matrix m = long_beam();
  Cholesky cholesky;
  cholesky.analyse(m);
  ASSERT_TRUE(cholesky.factorise(m));
  const Eigen::VectorXd load = Eigen::VectorXd::Ones(m.cols());
  Eigen::VectorXd exact(m.cols()), first(m.cols()), second(m.cols());
  cholesky.solve(load.data(), exact.data(), 1);
  cholesky.precondition(load.data(), first.data(), 1);
  cholesky.precondition(load.data(), second.data(), 1);
  EXPECT_EQ(first, exact);
  EXPECT_EQ(second, exact);
}

TEST(Cholesky, IsRoughWhereSinglePrecisionIsGoodEnough) {
  const Matrix a = random_positive(400, 1, 0), b = random_positive(400, 1, 1);
  const Eigen::VectorXd rhs = random_points(400, 2).col(0);
  Work work;
  Cholesky cholesky(&work);
  cholesky.analyse(a);
  const auto solution = [&](const Matrix& m, Precision precision) {
    EXPECT_TRUE(cholesky.factorise(m, {}, precision));
    Eigen::VectorXd x(400);
    cholesky.solve(rhs.data(), x.data(), 1);
    return x;
  };
  const Eigen::VectorXd rough = solution(b, Precision::rough);
  EXPECT_EQ(
      work.counts,
      (Counts{.factorisations = 1, .solves = 3, .factor_nonzeros = work.counts.factor_nonzeros}))
      << "two solves tell the error of the first rough factor";
  const Eigen::VectorXd exact = solution(b, Precision::exact);
  EXPECT_LT((b * exact - rhs).norm(), 1e-13 * rhs.norm());
  EXPECT_NE(rough, exact);
  EXPECT_TRUE(rough.isApprox(exact, 1e-5));
  EXPECT_EQ(solution(b, Precision::rough), rough) << "the exact factor has changed nothing";
  Eigen::VectorXd x(400);
  cholesky.precondition(rhs.data(), x.data(), 1);
  EXPECT_EQ(x, rough);
  EXPECT_EQ(work.counts.factorisations, 3);
  EXPECT_EQ(work.counts.solves, 6);
}

// The beam's error in single precision is told without its exact factor.
TEST(Cholesky, IsExactWhereARoughFactorWillNotDo) {
  const Matrix m = long_beam();
  const Eigen::VectorXd load = Eigen::VectorXd::Ones(m.cols());
  Eigen::VectorXd exact(m.cols()), x(m.cols());
  Cholesky other;
  other.analyse(m);
  ASSERT_TRUE(other.factorise(m));
  other.solve(load.data(), exact.data(), 1);
  Work work;
  Cholesky cholesky(&work);
  cholesky.analyse(m);
  for (const int factorisations : {2, 3}) {  // the first rough one is done again
    ASSERT_TRUE(cholesky.factorise(m, {}, Precision::rough));
    EXPECT_EQ(work.counts.factorisations, factorisations);
    cholesky.solve(load.data(), x.data(), 1);
    EXPECT_EQ(x, exact);
  }
}

// Factors of other patterns, smaller and larger ones, take the place of the last.
TEST(Cholesky, FactorisesOnePatternAfterAnother) {
  Cholesky cholesky;
  for (const int n : {60, 400, 60, 420, 900})
    for (const Precision precision : {Precision::rough, Precision::exact}) {
      const Matrix m = random_positive(n, 1, 0);
      const Eigen::VectorXd rhs = random_points(n, 2).col(0);
      Eigen::VectorXd x(n);
      cholesky.analyse(m);
      ASSERT_TRUE(cholesky.factorise(m, {}, precision));
      cholesky.solve(rhs.data(), x.data(), 1);
      EXPECT_LT((m * x - rhs).norm(), (precision == Precision::rough ? 1e-5 : 1e-13) * rhs.norm());
    }
}

// Single precision cannot tell 1 from 1 + 1e-9, so that the second pivot is none.
TEST(Cholesky, ARoughFailureIsVerifiedOnce) {
  const auto matrix = [](double last) {
    Matrix m(2, 2);
    m.insert(0, 0) = m.insert(1, 0) = m.insert(0, 1) = 1;
    m.insert(1, 1) = last;
    m.makeCompressed();
    return m;
  };
  const Matrix good = matrix(2), hardly = matrix(1 + 1e-9), bad = matrix(0.5);
  const Eigen::Vector2d rhs(1, 2);
  Eigen::Vector2d x;
  const auto learned = [&](Work& work) {
    Cholesky cholesky(&work);
    cholesky.analyse(good);
    EXPECT_TRUE(cholesky.factorise(good));
    cholesky.precondition(rhs.data(), x.data(), 1);
    return cholesky;
  };
  Work work;
  Cholesky cholesky = learned(work);
  EXPECT_FALSE(cholesky.factorise(bad, {}, Precision::rough));
  EXPECT_EQ(work.counts.factorisations, 3) << "and by an exact one";
  EXPECT_FALSE(cholesky.factorise(bad, {}, Precision::rough));
  EXPECT_EQ(work.counts.factorisations, 4);
  EXPECT_TRUE(cholesky.factorise(good, {}, Precision::rough));
  cholesky.solve(rhs.data(), x.data(), 1);
  EXPECT_TRUE(x.isApprox(Eigen::Vector2d(0, 1), 1e-6));

  Work other;
  cholesky = learned(other);
  EXPECT_TRUE(cholesky.factorise(hardly, {}, Precision::rough));
  cholesky.solve(rhs.data(), x.data(), 1);
  EXPECT_TRUE(x.isApprox(Eigen::Vector2d(1 - 1e9, 1e9), 1e-6)) << x.transpose();
  cholesky.precondition(rhs.data(), x.data(), 1);
  EXPECT_EQ(other.counts.factorisations, 3);
  EXPECT_TRUE(cholesky.factorise(good));
  cholesky.precondition(rhs.data(), x.data(), 1);
  EXPECT_TRUE(cholesky.factorise(hardly, {}, Precision::rough));
  EXPECT_EQ(other.counts.factorisations, 5) << "no other is rough";
}

TEST(Cholesky, OrdersByBlocksOfThree) {
  const Matrix graph = random_positive(20, 3, 6);
  std::vector<Eigen::Triplet<double>> entries;
  for (int c = 0; c < 20; ++c)
    for (Matrix::InnerIterator it(graph, c); it; ++it)
      for (int k = 0; k < 3; ++k) {
        entries.emplace_back(3 * it.row() + k, 3 * c + k, it.value());
        if (it.row() == c && k < 2) {
          entries.emplace_back(3 * c + k, 3 * c + k + 1, 0.3);
          entries.emplace_back(3 * c + k + 1, 3 * c + k, 0.3);
        }
      }
  Matrix m(60, 60);
  m.setFromTriplets(entries.begin(), entries.end());
  const Eigen::VectorXd rhs = Eigen::VectorXd::LinSpaced(60, -1, 1);
  Cholesky cholesky;
  cholesky.analyse(m, 3);
  ASSERT_TRUE(cholesky.factorise(m));
  Eigen::VectorXd x(60);
  cholesky.solve(rhs.data(), x.data(), 1);
  EXPECT_TRUE(x.isApprox(Eigen::MatrixXd(m).ldlt().solve(rhs), 1e-12));
}

// Without a factor of its own; the one of another matrix still solves.
TEST(Cholesky, TellsWhetherAMatrixIsPositiveDefiniteBesideAFactor) {
  const Matrix a = random_positive(900, 1, 0);
  for (const double shift : {0.0, -3.4}) {  // smallest eigenvalues of either sign
    const Matrix b = random_positive(900, 1, shift);
    const bool positive = Eigen::MatrixXd(b).selfadjointView<Eigen::Lower>().eigenvalues()[0] > 0;
    EXPECT_EQ(positive, shift == 0);
    for (const Precision precision : {Precision::exact, Precision::rough}) {
      Work work;
      Cholesky cholesky(&work);
      cholesky.analyse(a);
      EXPECT_EQ(cholesky.is_positive_definite(b), positive);
      EXPECT_FALSE(cholesky.factorised());
      ASSERT_TRUE(cholesky.factorise(a, {}, precision));
      EXPECT_EQ(cholesky.is_positive_definite(b), positive);
      EXPECT_THROW(cholesky.is_positive_definite(b, [] { return true; }), Interruption);
      EXPECT_EQ(work.counts.factorisations, 4);
      ASSERT_TRUE(cholesky.factorised());
      const Eigen::VectorXd rhs = Eigen::VectorXd::LinSpaced(a.rows(), -1, 2);
      Eigen::VectorXd x(a.rows());
      cholesky.solve(rhs.data(), x.data(), 1);
      EXPECT_LT((a * x - rhs).norm(), 1e-5 * rhs.norm());
    }
  }
}

TEST(Cholesky, SaysWhenAMatrixIsNotPositiveDefinite) {
  const Matrix a = random_positive(60, 1, 0);
  Matrix indefinite = a;
  indefinite.coeffRef(30, 30) = -1;
  Cholesky cholesky;
  cholesky.analyse(a);
  EXPECT_FALSE(cholesky.factorise(indefinite));
  EXPECT_FALSE(cholesky.factorised());
  EXPECT_TRUE(cholesky.factorise(a));  // still works afterwards
}

TEST(Blas, IsOpenBlas) {
  EXPECT_EQ(blas_name().rfind("OpenBLAS", 0), 0u) << blas_name();
}

}  // namespace
}  // namespace vasorod
