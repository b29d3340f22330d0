#include <gtest/gtest.h>

#include "numerics/analysed_grid.h"
#include "numerics/fronts.h"

namespace vasorod {
namespace {

using namespace testing;

TEST(Fronts, TheFactorTimesItsTransposeIsTheMatrix) {
  const Analysed a(grid(18));
  const Supernodes nodes(*a.factor);
  Fronts fronts(nodes);
  std::vector<double> factor(nodes.entries());
  ASSERT_TRUE(fronts.factorise(*a.sorted, factor.data()));
  const Eigen::MatrixXd l = dense_factor(nodes, factor),
                        expected = in_order(nodes, Eigen::MatrixXd(a.matrix));
  EXPECT_LT((l * l.transpose() - expected).norm(), 1e-14 * expected.norm());
}

TEST(Fronts, ThreadsDoNotChangeABit) {
  const Analysed a(grid(60));  // its largest fronts have several panels
  const Supernodes nodes(*a.factor);
  ASSERT_GT(nodes.tallest(), 250);
  std::vector<Eigen::MatrixXd> found;
  for (const int count : {1, 2, 7}) {
    set_threads(count);
    Fronts fronts(nodes);
    std::vector<double> factor(nodes.entries());
    ASSERT_TRUE(fronts.factorise(*a.sorted, factor.data()));
    found.push_back(dense_factor(nodes, factor));
  }
  set_threads(1);
  EXPECT_EQ(found[1], found[0]);
  EXPECT_EQ(found[2], found[0]);
}

// Also where it was not positive definite just before, in another subtree or above all of them.
TEST(Fronts, AMatrixThatIsNotPositiveDefiniteIsFoundWhereverItIs) {
  Analysed a(grid(20));
  const Supernodes nodes(*a.factor);
  Fronts fronts(nodes);
  std::vector<double> factor(nodes.entries());
  auto* values = static_cast<double*>(a.sorted->x);
  const auto* begin = static_cast<const int*>(a.sorted->p);
  for (const int count : {1, 2}) {
    set_threads(count);
    for (int column = 0; column < nodes.unknowns(); column += 83) {
      const double good = values[begin[column]];
      values[begin[column]] = -good;
      EXPECT_FALSE(fronts.factorise(*a.sorted, factor.data())) << column;
      values[begin[column]] = good;
      ASSERT_TRUE(fronts.factorise(*a.sorted, factor.data())) << column;
    }
  }
  set_threads(1);
  values[begin[7]] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(fronts.factorise(*a.sorted, factor.data()));
}

}  // namespace
}  // namespace vasorod
