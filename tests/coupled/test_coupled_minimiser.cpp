// Minima of a system with given contacts and multipliers, and the verdict on them.
#include <gtest/gtest.h>

#include "coupled/coupled_path.h"
#include "coupled/held_tubes.h"

namespace vasorod {
namespace {

using namespace testing;

// A straight tube, pushed together along its axis.
struct Pushed {
  Pushed(double share, const HeldTube& tube)
      : stack(bent(tube, (Vec6() << 0, 0, -share, 0, 0, 0).finished(), tube.start(), tube.end()),
              {}),
        path(stack) {
    stack.build();
    path.restart();
    path.advance(1);
  }
  CoupledMinimiserSummary minimise(bool rough_factors) {
    CoupledMinimiserOptions options;
    options.rough_factors = rough_factors;
    const CoupledMinimiserSummary summary = stack.minimiser->minimise(stack.z, options);
    stack.unstack();
    return summary;
  }
  double aside() const { return stack.scaled.bodies[0].now.colwise().mean().head<2>().norm(); }

  CoupledStack stack;
  CoupledPath path;
};

TEST(CoupledMinimiser, CertifiesWithRoughFactorsWhatItCertifiesWithExactOnes) {
  const HeldTube tube(12, 2, 0.3, 12, 12);
  for (const bool rough : {false, true}) {
    Pushed pushed(0.02, tube);
    const CoupledMinimiserSummary summary = pushed.minimise(rough);
    EXPECT_EQ(summary.status, LbfgsStatus::converged) << rough;
    EXPECT_TRUE(summary.positive) << rough;
    EXPECT_FALSE(summary.left_saddle) << rough;
    EXPECT_LT(summary.residual, 1e-9) << rough;
    EXPECT_LT(pushed.aside(), 1e-6) << rough;
  }
}

// Where a slender tube begins to bend like a column, its forces balance, and it turns about its
// axis at no cost.
TEST(CoupledMinimiser, DoesNotCertifyAColumnThatMayTurnAboutItsAxis) {
  const HeldTube tube(40, 1, 0.2, 8, 40);
  for (const bool rough : {false, true}) {
    Pushed pushed(0.014, tube);
    const CoupledMinimiserSummary summary = pushed.minimise(rough);
    EXPECT_EQ(summary.status, LbfgsStatus::converged) << rough;
    EXPECT_LT(summary.residual, 1e-9) << rough;
    EXPECT_FALSE(summary.positive) << rough;
    EXPECT_TRUE(summary.neutral) << rough;
  }
}

}  // namespace
}  // namespace vasorod
