// The collapsed ring at the other published pressures, and beyond them.
#include <cmath>
#include <gtest/gtest.h>

#include "coupled/collapsed_ring.h"

namespace vasorod {
namespace {

using namespace testing;

TEST(SelfContactAccuracy, ACollapsedRingsAreaIsThePublishedOne) {
  const CollapsedRing ring;
  for (const auto& [q, share] : {std::pair{3.5, 0.74952}, {5.0, 0.31702}}) {
    const CoupledSolution solution = ring.at(q);
    EXPECT_EQ(solution.status, Status::buckled) << solution.brief_report();
    EXPECT_NEAR(ring.area_ratio(solution), share, 0.02 * share) << q;
  }
}

// Beyond line contact the two lobes are similar at all pressures: the area goes as q^(-2/3).
TEST(SelfContactAccuracy, BeyondLineContactTheAreaFollowsThePowerLaw) {
  const CollapsedRing ring;
  const CoupledSolution solution = ring.at(20);
  EXPECT_EQ(solution.status, Status::buckled) << solution.brief_report();
  const double share = 0.20943 * std::pow(20 / 10.3360, -2.0 / 3);
  EXPECT_NEAR(ring.area_ratio(solution), share, 0.02 * share);
  EXPECT_GT(solution.surface.contacts.at(0).area, 4);
}

}  // namespace
}  // namespace vasorod
