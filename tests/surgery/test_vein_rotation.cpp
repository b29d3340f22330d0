#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "rod/rods.h"
#include "surgery/vein_rotation.h"

namespace vasorod {
namespace {

// A straight vein along z, its far end clamped, its mouth turned about z by `turn`.
struct Vein {
  RodTree rod = chain({}, 30, Vec3::Zero(), 12, isotropic(40, 100, 50, 40));
  RodConditions conditions;
  Pose mouth;
  Vein(double turn) {
    rod.radius.assign(rod.rest.size(), 4);
    conditions.supports = {clamp(0)};
    mouth = {exp_rotation(Vec3(0, 0, turn)), Vec3(0, 0, 30)};
  }
  VeinRotation rotation() const { return {rod, conditions, 12, mouth, Vec3::UnitZ(), {}}; }
};

TEST(VeinRotation, AStraightVeinsTwistShearIsItsAngleOverItsLength) {
  const Vein vein(0.5);
  VeinRotation rotation = vein.rotation();
  for (const double angle : {0.0, 0.3, -0.9})
    EXPECT_NEAR(rotation.largest_twist_shear(angle), 4 * std::abs(0.5 + angle) / 30, 1e-9) << angle;
  EXPECT_EQ(rotation.at(0.3).summary.status, Status::converged);
}

TEST(VeinRotation, TheBestAngleUndoesTheMouthsTurn) {
  for (const double turn : {0.5, -1.3, 2.2}) {
    const Vein vein(turn);
    VeinRotation rotation = vein.rotation();
    const double best = rotation.find();
    const double left = std::remainder(best + turn, 2 * std::numbers::pi);
    EXPECT_NEAR(left, 0, 1e-3) << turn;
    EXPECT_LT(rotation.largest_twist_shear(best), 1e-3);
  }
}

TEST(VeinRotation, TheConditionsHoldTheMouthWhereTheAngleSays) {
  const Vein vein(0.2);
  const RodConditions conditions = vein.rotation().conditions_at(0.7);
  ASSERT_EQ(conditions.supports.size(), 2u);
  EXPECT_EQ(conditions.supports[1].node, 12);
  const Pose target = target_pose(vein.rod, conditions.supports[1]);
  EXPECT_LT((target.rotation - exp_rotation(Vec3(0, 0, 0.9))).norm(), 1e-12);
  EXPECT_LT((target.position - vein.mouth.position).norm(), 1e-12);
}

}  // namespace
}  // namespace vasorod
