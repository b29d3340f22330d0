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

// A cube of points, each coupled with its six neighbours.
Eigen::SparseMatrix<double> cube(int side) {
  std::vector<Eigen::Triplet<double>> entries;
  const int n = side * side * side;
  for (int here = 0; here < n; ++here) {
    entries.emplace_back(here, here, 7);
    for (const int step : {1, side, side * side})
      if (here / step % side + 1 < side) {
        entries.emplace_back(here, here + step, -1);
        entries.emplace_back(here + step, here, -1);
      }
  }
  Eigen::SparseMatrix<double> matrix(n, n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

// Minimum degree's where that is little work; not in a cube, nor where the graph is large.
TEST(Analysis, TheCheaperOrder) {
  struct Case {
    Eigen::SparseMatrix<double> matrix;
    int group;
    Ordering taken;
  };
  for (const auto& [matrix, group, taken] : {Case{grid(40), 3, Ordering::minimum_degree},
                                             {cube(30), 1, Ordering::nested_dissection},
                                             {grid(230), 3, Ordering::nested_dissection}}) {
    std::vector<int> groups;
    for (int first = 0; first < matrix.cols(); first += group) groups.push_back(first);
    const std::vector<int> cheaper = elimination_order(matrix, groups, Ordering::cheaper);
    EXPECT_TRUE(cheaper == elimination_order(matrix, groups, taken)) << groups.size() << " groups";
  }
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
