// The collapsed ring at the other published pressures, and beyond them.
#include <gtest/gtest.h>

#include "accuracy/collapsed_ring.h"

namespace vasorod {
namespace {

using bench::CollapsedRing, bench::published_area;

TEST(SelfContactAccuracy, ACollapsedRingsAreaIsThePublishedOne) {
  const CollapsedRing ring;
  for (const double q : {3.5, 5.0}) {
    const CoupledSolution solution = ring.at(q);
    EXPECT_EQ(solution.status, Status::buckled) << solution.brief_report();
    EXPECT_NEAR(ring.area_ratio(solution), published_area(q), 0.02 * published_area(q)) << q;
  }
}

// Beyond line contact the two lobes are similar at all pressures: the area goes as q^(-2/3).
TEST(SelfContactAccuracy, BeyondLineContactTheAreaFollowsThePowerLaw) {
  const CollapsedRing ring;
  const CoupledSolution solution = ring.at(20);
  EXPECT_EQ(solution.status, Status::buckled) << solution.brief_report();
  EXPECT_NEAR(ring.area_ratio(solution), published_area(20), 0.02 * published_area(20));
  EXPECT_GT(solution.surface.contacts.at(0).area, 4);
}

}  // namespace
}  // namespace vasorod
