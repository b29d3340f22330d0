#include <gtest/gtest.h>
#include <numeric>
#include <thread>

#include "numerics/analysed_grid.h"
#include "numerics/fronts.h"

namespace vasorod {
namespace {

using namespace testing;

template <class Scalar>
void expect_factor(double tolerance) {
  AnalysedGrid a(18);
  Fronts<Scalar> fronts(a.nodes);
  std::vector<Scalar> factor(a.nodes.entries());
  ASSERT_TRUE(fronts.factorise(a.analysis.in_order(a.matrix), factor.data(), 1));
  const Eigen::MatrixXd l = dense_factor(a.nodes, {factor.begin(), factor.end()}),
                        expected = in_order(a.nodes, Eigen::MatrixXd(a.matrix));
  EXPECT_LT((l * l.transpose() - expected).norm(), tolerance * expected.norm());
  a.matrix.coeffRef(7, 7) = -1;
  EXPECT_FALSE(fronts.factorise(a.analysis.in_order(a.matrix), factor.data(), 1));
}

TEST(Fronts, TheFactorTimesItsTransposeIsTheMatrix) {
  expect_factor<double>(1e-14);
  expect_factor<float>(1e-6);
}

TEST(Fronts, ThreadsDoNotChangeABit) {
  AnalysedGrid a(60);  // its largest fronts have several panels
  ASSERT_GT(a.nodes.tallest(), 250);
  std::vector<Eigen::MatrixXd> found;
  for (const int count : {1, 2, 7}) {
    Fronts<double> fronts(a.nodes);
    std::vector<double> factor(a.nodes.entries());
    ASSERT_TRUE(fronts.factorise(a.analysis.in_order(a.matrix), factor.data(), count));
    found.push_back(dense_factor(a.nodes, factor));
  }
  EXPECT_EQ(found[1], found[0]);
  EXPECT_EQ(found[2], found[0]);
}

// Three groups of unknowns, each full: the third, of several panels, is coupled in parts to both
// others, which so are its children.
TEST(Fronts, AWideFrontIsPutTogetherByAllThreads) {
  constexpr int narrow = 200, wide = 420, coupled = 300, n = 2 * narrow + wide;
  Eigen::MatrixXd full = Eigen::MatrixXd::Random(n, n);
  full.block(narrow, 0, narrow, narrow).setZero();
  full.block(2 * narrow + coupled, 0, wide - coupled, narrow).setZero();
  full.block(2 * narrow, narrow, wide - coupled, narrow).setZero();
  full.triangularView<Eigen::Upper>() = full.transpose();
  full.diagonal().array() = n;
  const Eigen::SparseMatrix<double> matrix = full.sparseView();
  std::vector<int> order(n);
  std::iota(order.begin(), order.end(), 0);
  Analysis analysis(matrix, order);
  const Supernodes& nodes = analysis.nodes();
  ASSERT_EQ(nodes[nodes.size() - 1].columns, wide);
  int children = 0;
  nodes.for_children(nodes.size() - 1, [&](int) { ++children; });
  ASSERT_EQ(children, 2);
  std::vector<Eigen::MatrixXd> found;
  for (const int threads : {1, 2, 5}) {
    std::vector<double> factor(nodes.entries());
    ASSERT_TRUE(Fronts<double>(nodes).factorise(analysis.in_order(matrix), factor.data(), threads));
    found.push_back(dense_factor(nodes, factor));
    EXPECT_EQ(found.back(), found.front()) << threads;
  }
  const Eigen::MatrixXd expected = in_order(nodes, full);
  EXPECT_LT((found[0] * found[0].transpose() - expected).norm(), 1e-14 * expected.norm());
}

// And one that is, after it.
TEST(Fronts, AMatrixThatIsNotPositiveDefiniteIsFoundWhereverItIs) {
  AnalysedGrid a(20);
  Fronts<double> fronts(a.nodes);
  std::vector<double> factor(a.nodes.entries());
  const auto factorise = [&](int threads) {
    return fronts.factorise(a.analysis.in_order(a.matrix), factor.data(), threads);
  };
  for (const int threads : {1, 2})
    for (int column = 0; column < a.nodes.unknowns(); column += 83) {
      const int u = a.nodes.order()[static_cast<size_t>(column)];
      const double good = a.matrix.coeff(u, u);
      a.matrix.coeffRef(u, u) = -good;
      EXPECT_FALSE(factorise(threads)) << column;
      a.matrix.coeffRef(u, u) = good;
      ASSERT_TRUE(factorise(threads)) << column;
    }
  a.matrix.coeffRef(7, 7) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(factorise(1));
}

// At every question in turn, and from the calling thread alone; the next factor is as ever.
TEST(Fronts, IsStoppedBetweenFrontsAndFactorisesAfterwards) {
  AnalysedGrid a(36);
  Fronts<double> fronts(a.nodes);
  std::vector<double> factor(a.nodes.entries()), expected(a.nodes.entries());
  ASSERT_TRUE(fronts.factorise(a.analysis.in_order(a.matrix), expected.data(), 1));
  for (const int threads : {1, 3}) {
    int asked = 0, last = 0;
    bool elsewhere = false;
    const auto stop = [&] {
      static const std::thread::id caller = std::this_thread::get_id();
      elsewhere |= std::this_thread::get_id() != caller;
      return ++asked == last;
    };
    const auto factorise = [&] {
      asked = 0;
      return fronts.factorise(a.analysis.in_order(a.matrix), factor.data(), threads, stop);
    };
    ASSERT_TRUE(factorise());
    const int questions = asked;
    ASSERT_GT(questions, 5) << threads;
    for (last = 1; last <= (threads == 1 ? questions : 3); ++last) {
      EXPECT_THROW(factorise(), Interruption) << last;
      EXPECT_EQ(asked, last);
    }
    last = 0;
    ASSERT_TRUE(factorise());
    EXPECT_EQ(dense_factor(a.nodes, factor), dense_factor(a.nodes, expected));
    EXPECT_FALSE(elsewhere);
  }
}

}  // namespace
}  // namespace vasorod
