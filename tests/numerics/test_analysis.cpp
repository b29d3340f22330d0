#include <cholmod.h>
#include <gtest/gtest.h>
#include <numeric>
#include <thread>

#include "numerics/analysed_grid.h"

namespace vasorod {
namespace {

using namespace testing;

// METIS draws from one sequence of random numbers for the whole process.
TEST(Analysis, OrderingsAtTheSameTimeAreThoseOfOneAlone) {
  const Eigen::SparseMatrix<double> a = grid(32);
  std::vector<int> each(static_cast<size_t>(a.cols()));
  std::iota(each.begin(), each.end(), 0);
  const auto order = [&] { return elimination_order(a, each, Ordering::nested_dissection); };
  const std::vector<int> alone = order();
  std::vector<std::vector<int>> together(8);
  std::vector<std::thread> threads;
  for (std::vector<int>& one : together) threads.emplace_back([&] { one = order(); });
  for (std::thread& thread : threads) thread.join();
  for (const std::vector<int>& one : together) EXPECT_EQ(one, alone);
}

TEST(Analysis, OrdersTheLowerTriangleOfEachMatrixOfThePattern) {
  AnalysedGrid a(9);
  for (const double factor : {1.0, -3.0}) {
    a.matrix *= factor;
    const cholmod_sparse& found = a.analysis.in_order(a.matrix);
    const Eigen::Map<const Eigen::SparseMatrix<double>> lower(
        a.matrix.rows(), a.matrix.cols(), static_cast<const int*>(found.p)[a.matrix.cols()],
        static_cast<const int*>(found.p), static_cast<const int*>(found.i),
        static_cast<const double*>(found.x));
    const Eigen::MatrixXd expected =
        in_order(a.nodes, Eigen::MatrixXd(a.matrix)).triangularView<Eigen::Lower>();
    EXPECT_EQ(Eigen::MatrixXd(lower), expected);
  }
}

TEST(Analysis, AGivenOrderIsKeptAndItsFillCounted) {
  constexpr int n = 40;  // a chain eliminated from one end has no fill
  std::vector<Eigen::Triplet<double>> entries;
  std::vector<int> along(n);
  std::iota(along.begin(), along.end(), 0);
  for (int i = 0; i < n; ++i) {
    entries.emplace_back(i, i, 3);
    if (i > 0) entries.emplace_back(i, i - 1, 1);
  }
  Eigen::SparseMatrix<double> chain(n, n);
  chain.setFromTriplets(entries.begin(), entries.end());
  const Analysis analysis(chain, along);
  EXPECT_EQ(analysis.factor_nonzeros(), 2 * n - 1);
  EXPECT_EQ(analysis.nodes().order(), along);
}

}  // namespace
}  // namespace vasorod
