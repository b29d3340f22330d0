// Contact of whole tubes on different meshes. The benchmark contact_accuracy goes to 25,000
// vertices.
#include <gtest/gtest.h>

#include "accuracy/pressed_tubes.h"

namespace vasorod::bench {
namespace {

void expect_kept(const PressedTubes& pressed) {
  EXPECT_TRUE(pressed.settled);
  EXPECT_LT(pressed.support_misfit, 1e-6);
  EXPECT_LT(pressed.newton_misfit, 1e-9);
  EXPECT_LT(pressed.penetration, 1e-3);
}

TEST(ContactAccuracy, TheForceIsTheSameOnThreeThousandAndOnTwelveThousandVertices) {
  const PressedTubes coarse = pressed_on_cylinder(48, 10), fine = pressed_on_cylinder(96, 10);
  for (const PressedTubes* pressed : {&coarse, &fine}) {
    expect_kept(*pressed);
    EXPECT_LT(pressed->pressure_misfit.value_or(1), 1e-3);
  }
  EXPECT_NEAR(coarse.force.norm(), fine.force.norm(), 0.02 * fine.force.norm());
}

TEST(ContactAccuracy, TwoTubesThatBothYieldPressAlikeOnTwoMeshes) {
  const PressedTubes coarse = two_tubes(Meeting::across, 24), fine = two_tubes(Meeting::across, 36);
  expect_kept(coarse);
  expect_kept(fine);
  EXPECT_NEAR(coarse.force.norm(), fine.force.norm(), 0.02 * fine.force.norm());
}

// Held in the mean only, the tubes slide on each other until the contact points no longer change.
TEST(ContactAccuracy, TwoTubesBetweenSoftEndsSettleSideBySide) {
  const PressedTubes coarse = two_tubes(Meeting::side_by_side, 20),
                     fine = two_tubes(Meeting::side_by_side, 28);
  expect_kept(coarse);
  expect_kept(fine);
  EXPECT_NEAR(coarse.force.norm(), fine.force.norm(), 0.02 * fine.force.norm());
}

TEST(ContactAccuracy, ARingOnAPlateHasItsClosedFormStiffness) {
  const RingOnPlate ring = ring_on_plate(64, 0.02);
  EXPECT_TRUE(ring.settled);
  EXPECT_NEAR(ring.force / ring.closed_form, 1, 0.015);
  EXPECT_NEAR(ring.pressure_sum / ring.force, 1, 1e-9);
}

}  // namespace
}  // namespace vasorod::bench
