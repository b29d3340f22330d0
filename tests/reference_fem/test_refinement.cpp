// The grid convergence index against NASA's worked example (NPARC verification page: 0.97050,
// 0.96854, 0.96178, r = 2).
#include <cmath>
#include <gtest/gtest.h>

#include "reference_fem/refinement.h"

namespace vasorod::fem {
namespace {

TEST(Refinement, GridConvergenceIndexOfNasasExample) {
  const double f1 = 0.97050, f2 = 0.96854, f3 = 0.96178;
  const Convergence c = grid_convergence(f1 - f2, f2 - f3, 2, 1.8);
  EXPECT_NEAR(*c.observed_order, 1.78616959, 1e-8);
  EXPECT_EQ(c.safety, 1.25);
  EXPECT_NEAR(c.uncertainty / f1, 1.030826e-3, 1e-9);
  const Convergence coarse = grid_convergence(f2 - f3, std::nullopt, 2, *c.observed_order);
  EXPECT_NEAR(coarse.uncertainty / f2 * 1.25 / 3, 3.562493e-3,
              1e-8);  // without a third mesh Fs = 3
}

TEST(Refinement, DoesNotTrustAnOrderAboveTheory) {
  const Convergence c = grid_convergence(1e-6, 1e-2, 1.5, 4);
  EXPECT_GT(*c.observed_order, 20);
  EXPECT_EQ(c.order, 4);
  EXPECT_EQ(c.safety, 3);
}

TEST(Refinement, AssumesSecondOrderFromTwoMeshes) {
  EXPECT_NEAR(grid_convergence(1e-3, std::nullopt, 1.5, 6).uncertainty, 3e-3 / 1.25, 1e-15);
}

TEST(Refinement, SaysMuchWhereNothingConverges) {
  EXPECT_GE(grid_convergence(2e-3, 1e-3, 1.5, 4).uncertainty, 2e-3);
}

}  // namespace
}  // namespace vasorod::fem
