#include <cmath>
#include <gtest/gtest.h>
#include <limits>

#include "numerics/stress_free_search.h"

namespace vasorod {
namespace {

using Eigen::VectorXd;

// Bars of seen length 1, each under a pull: of the free length X the tension is E (1 / X - 1). So
// X = 1 / (1 + pull / E).
class Bars : public StressFreeProblem {
 public:
  Bars(VectorXd pull, VectorXd young) : pull_(std::move(pull)), young_(std::move(young)) {}

  bool set(double share, const VectorXd& x) override {
    ++sets;
    share_ = share;
    free_ = VectorXd::Ones(x.size()) - x;
    return free_.minCoeff() > 0 && share <= largest_share;
  }
  VectorXd step(const VectorXd&) override {
    const VectorXd tension = young_.cwiseProduct((free_.cwiseInverse().array() - 1).matrix());
    return (share_ * pull_ - tension).cwiseQuotient(young_);
  }
  double length(const VectorXd& x) const override { return x.norm(); }

  VectorXd linear() const { return pull_.cwiseQuotient(young_); }
  VectorXd exact() const { return (1 - (1 + linear().array()).inverse()).matrix(); }
  double largest_share = 1;
  int sets = 0;

 private:
  VectorXd pull_, young_, free_;
  double share_ = 0;
};

Bars some_bars(double size) {
  return {size * VectorXd::LinSpaced(5, 0.5, 1), VectorXd::LinSpaced(5, 1, 0.8)};
}

TEST(StressFreeSearch, FindsTheFreeLengthOfBars) {
  for (const double size : {0.1, 0.3, 0.5}) {
    Bars bars = some_bars(size);
    VectorXd x = bars.linear();
    const int steps = search_stress_free(bars, x);
    EXPECT_GT(steps, 0) << size;
    EXPECT_LT(steps, 60) << size;
    EXPECT_LT((x - bars.exact()).norm(), 1e-11 * x.norm()) << size;
  }
}

// The linear displacement is longer than the bars: only a way of shares leads there.
TEST(StressFreeSearch, TakesMoreSharesWhereOneDoesNotLead) {
  Bars bars = some_bars(1.1);
  VectorXd x = bars.linear();
  ASSERT_GT(x.maxCoeff(), 1);
  EXPECT_GT(search_stress_free(bars, x), 0);
  EXPECT_LT((x - bars.exact()).norm(), 1e-11 * x.norm());
}

TEST(StressFreeSearch, LeavesTheDisplacementWhereItFindsNone) {
  Bars bars = some_bars(0.4);
  bars.largest_share = 0.5;
  VectorXd x = bars.linear();
  EXPECT_EQ(search_stress_free(bars, x), 0);
  EXPECT_EQ(x, bars.linear());
}

TEST(StressFreeSearch, StopsWhereItIsTold) {
  Bars bars = some_bars(0.4);
  VectorXd x = bars.linear();
  EXPECT_EQ(search_stress_free(bars, x, [&] { return bars.sets > 3; }), 0);
  EXPECT_EQ(x, bars.linear());
  EXPECT_LT(bars.sets, 8);
}

}  // namespace
}  // namespace vasorod
