// Two rods whose rims meet, against the one rod that they make.
#include <cmath>
#include <gtest/gtest.h>

#include "rod/rods.h"
#include "surgery/meeting.h"

namespace vasorod {
namespace {

constexpr double bending = 40, axial = 100, shear = 50, torsion = 40;

// Straight rods along z: the first from the origin, the second from `gap` behind it on. Their far
// ends are clamped, the second's is moved by `motion`.
struct Two {
  RodTree first = chain({}, 30, Vec3::Zero(), 12, isotropic(bending, axial, shear, torsion)),
          second;
  std::array<RimRod, 2> rims;

  Two(double gap, const RodMotion& motion, const Pose& place = {}) {
    first.radius.assign(first.rest.size(), 4);
    second = first;
    for (Pose& pose : second.rest) pose.position.z() += 30 + gap;
    for (RodTree* rod : {&first, &second})
      for (Pose& pose : rod->rest) pose = place * pose;
    RodSupport moved = clamp(12);
    moved.motion = motion;
    moved.motion.rotate = place.rotation * motion.rotate;
    moved.motion.move = place.rotation * motion.move;
    rims[0] = {&first, {{clamp(0)}, {}}, 12, first.rest[12], 4};
    rims[1] = {&second, {{moved}, {}}, 0, second.rest[0], 4};
    // Its normal points out of the vessel, against the rod.
    rims[1].rim.rotation.col(1) *= -1;
    rims[1].rim.rotation.col(2) *= -1;
  }
};

const RodReaction& at(const RodSolution& rod, int node) {
  for (const RodReaction& reaction : rod.reactions)
    if (reaction.node == node) return reaction;
  throw std::logic_error("no reaction there");
}

// The whole rod under the same conditions, with every node that the two have.
RodSolution whole(const RodMotion& motion) {
  const RodTree rod = chain({}, 60, Vec3::Zero(), 24, isotropic(bending, axial, shear, torsion));
  RodSupport moved = clamp(24);
  moved.motion = motion;
  return solve_rod(rod, {{clamp(0), moved}, {}});
}

TEST(Meeting, TwoHalvesOfARodAreThatRod) {
  const RodMotion motions[] = {{Vec3(0, 0.6, 0), Vec3(9, 0, -3)},
                               {Vec3(0.3, -0.5, 0.4), Vec3(-4, 6, -2)}};
  for (const RodMotion& motion : motions) {
    const Two two(0, motion);
    const Meeting met = meet(two.rims, 0, {});
    const RodSolution one = whole(motion);
    ASSERT_EQ(one.summary.status, Status::converged);
    for (size_t k = 0; k < 2; ++k) {
      ASSERT_EQ(met.rods[k].summary.status, Status::converged);
      for (size_t n = 0; n <= 12; ++n) {
        const Pose &mine = met.rods[k].poses[n], &other = one.poses[12 * k + n];
        EXPECT_LT((mine.position - other.position).norm(), 1e-7 * 60);
        EXPECT_LT((mine.rotation - other.rotation).norm(), 1e-7);
      }
    }
    EXPECT_LT((at(met.rods[1], 12).force - at(one, 24).force).norm(),
              1e-7 * at(one, 24).force.norm());
    EXPECT_LT((at(met.rods[0], 0).moment - at(one, 0).moment).norm(),
              1e-7 * at(one, 0).moment.norm());
    EXPECT_NEAR(met.axis_turn, 0, 1e-12);
  }
}

// Closing a gap of 3 in a rod of 60 whose ends stay: the stretch 3 / 60 everywhere.
TEST(Meeting, AGapIsClosedByTheStretchOfBothRods) {
  const Two two(3, {});
  const Meeting met = meet(two.rims, 0, {});
  const double force = axial * 3 / 60;
  for (size_t k = 0; k < 2; ++k) ASSERT_EQ(met.rods[k].summary.status, Status::converged);
  EXPECT_NEAR(at(met.rods[0], 0).force.z(), -force, 1e-8 * force);
  EXPECT_NEAR(at(met.rods[1], 12).force.z(), force, 1e-8 * force);
  EXPECT_NEAR(met.rods[0].poses[12].position.z(), 31.5, 1e-8);
}

TEST(Meeting, APrescribedRotationIsTheTorsionOfBothRods) {
  for (const double degrees : {20.0, -50.0, 170.0}) {
    const double angle = degrees * M_PI / 180;
    const Two two(0, {});
    const Meeting met = meet(two.rims, angle, {});
    // The second rim turns by the angle about the first's normal, +z: so its far end holds it back.
    const double torque = torsion * angle / 60;
    EXPECT_NEAR(at(met.rods[1], 12).moment.z(), -torque, 1e-8 * std::abs(torque)) << degrees;
    EXPECT_NEAR(at(met.rods[0], 0).moment.z(), torque, 1e-8 * std::abs(torque)) << degrees;
    EXPECT_EQ(met.rotation, angle);
  }
}

TEST(Meeting, TheAutomaticRotationLeavesNoTorqueInTheSeam) {
  const Two twisted(0, {Vec3(0, 0, 0.7), Vec3::Zero()});
  const Meeting met = meet(twisted.rims, std::nullopt, {});
  EXPECT_NEAR(met.rotation, 0.7, 1e-8);
  EXPECT_LT(at(met.rods[0], 0).moment.norm(), 1e-8 * torsion / 60);
  // Bent too, the torque about the seam's normal is zero there and the energy least.
  const Two bent(2, {Vec3(0.3, -0.5, 0.4), Vec3(-4, 6, -2)});
  const Meeting best = meet(bent.rims, std::nullopt, {});
  const auto energy = [](const Meeting& m) {
    return m.rods[0].summary.energy + m.rods[1].summary.energy;
  };
  const RodReaction& seam = at(best.rods[0], 12);
  EXPECT_LT(std::abs(seam.moment.dot(best.rods[0].poses[12].director(3))),
            1e-7 * seam.moment.norm());
  for (const double aside : {-0.05, 0.05})
    EXPECT_GT(energy(meet(bent.rims, best.rotation + aside, {})), energy(best));
}

TEST(Meeting, ForcesAndMomentsOfBothRodsCancelAtTheSeamWhereverItLies) {
  const RodMotion motion{Vec3(0.2, 0.9, 0.1), Vec3(8, 3, -6)};
  const Two here(1, motion);
  Pose place;
  place.rotation = exp_rotation(Vec3(0.4, -1.1, 0.3));
  place.position = Vec3(20, -7, 3);
  const Two there(1, motion, place);
  const Meeting a = meet(here.rims, 0.3, {}), b = meet(there.rims, 0.3, {});
  const RodReaction &first = at(a.rods[0], 12), &second = at(a.rods[1], 0);
  EXPECT_LT((first.force + second.force).norm(), 1e-8 * first.force.norm());
  EXPECT_LT((first.moment + second.moment).norm(), 1e-7 * first.moment.norm());
  EXPECT_LT((first.center - second.center).norm(), 1e-9 * 60);
  EXPECT_LT((at(b.rods[0], 12).force - place.rotation * first.force).norm(),
            1e-7 * first.force.norm());
}

TEST(Meeting, TheAxisTurnIsTheAngleBetweenTheRims) {
  Two two(0, {});
  const double angle = 0.8;
  Pose turn;
  turn.rotation = exp_rotation(Vec3(angle, 0, 0));
  turn.position = Vec3(0, 0, 30) - turn.rotation * Vec3(0, 0, 30);
  for (Pose& pose : two.second.rest) pose = turn * pose;
  two.rims[1].rim = turn * two.rims[1].rim;
  const Meeting met = meet(two.rims, 0, {});
  EXPECT_NEAR(met.axis_turn, angle, 1e-12);
  // Face to face now.
  const Vec3 first = met.rods[0].poses[12].director(3), second = met.rods[1].poses[0].director(3);
  EXPECT_LT((first - second).norm(), 1e-9);
}

}  // namespace
}  // namespace vasorod
