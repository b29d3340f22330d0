#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "edge_ratios.h"
#include "geometry/rigid_motion.h"
#include "infant_anatomy.h"
#include "straight_tube.h"
#include "vessel/fork_reach.h"
#include "vessel/shapes.h"

namespace vasorod {
namespace {

// Each branch bent about its d1 or d2, twisted and stretched, every branch otherwise.
RodPoses branches_bent(const RodTree& rod, double size) {
  RodPoses poses = rod.rest;
  for (size_t b = 0; b < rod.branches.size(); ++b)
    for (const int e : rod.branches[b].elements) {
      const RodElement& element = rod.elements[static_cast<size_t>(e)];
      Vec6 strain = element.rest_strain;
      const double sign = b % 2 == 0 ? 1 : -1;
      strain[2] += 0.2 * size * sign;
      strain[b % 3 == 0 ? 3 : 4] += 0.25 * size * sign;
      strain[5] -= 0.25 * size * sign;
      poses[static_cast<size_t>(element.second)] =
          poses[static_cast<size_t>(element.first)] * exp_motion(element.length * strain);
    }
  return poses;
}

TEST(ForkReach, AVesselWithoutForksFollowsItsOwnSections) {
  const Vessel vessel = fit_vessel("tube", tube_surface(testing::straight_tube(60, 6, 24, 36)));
  ASSERT_EQ(vessel.carry.size(), vessel.binding.size());
  for (size_t v = 0; v < vessel.carry.size(); ++v) {
    EXPECT_EQ(vessel.carry[v].element, vessel.binding[v].element);
    EXPECT_EQ(vessel.carry[v].s, vessel.binding[v].s);
    EXPECT_EQ(vessel.carry[v].local, vessel.binding[v].local);
  }
  for (const char fork : fork_elements(vessel)) EXPECT_FALSE(fork);
}

TEST(ForkReach, RestAndRigidMotionsAreCarriedExactly) {
  const Vessel vessel = fit_vessel("aorta", testing::infant("aorta"));
  const Pose motion = shapes::some_motion();
  RodPoses moved = vessel.rod.rest;
  for (Pose& pose : moved) pose = motion * pose;
  const Points still = carried_points(vessel.rod, vessel.rod.rest, vessel.carry),
               there = carried_points(vessel.rod, moved, vessel.carry);
  EXPECT_LT((still - vessel.surface.points).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_LT((there - shapes::moved(vessel.surface, motion).points).cwiseAbs().maxCoeff(), 1e-9);
}

// The border of the pulmonary artery's branches moves with the fork, in one piece; beyond three
// reaches every vertex follows its own section.
TEST(ForkReach, ABorderMovesWithItsForkAndTheRestWithItsSections) {
  const Vessel vessel = fit_vessel("pulmonary_artery", testing::infant("pulmonary_artery"));
  const RodTree& rod = vessel.rod;
  const RodPoses poses = branches_bent(rod, 0.1);
  const Points carried = carried_points(rod, poses, vessel.carry),
               sections = carried_points(rod, poses, vessel.binding);
  const auto fork = static_cast<size_t>(rod.branches[1].nodes.front());
  const Pose motion = poses[fork] * rod.rest[fork].inverse();
  const auto branch_of = [&](int v) { return vessel.branch_of[static_cast<size_t>(v)]; };
  int border = 0;
  for (Eigen::Index t = 0; t < vessel.surface.triangles.rows(); ++t) {
    const Eigen::RowVector3i corner = vessel.surface.triangles.row(t);
    if (branch_of(corner[0]) == branch_of(corner[1]) &&
        branch_of(corner[1]) == branch_of(corner[2]))
      continue;
    for (int k = 0; k < 3; ++k) {
      const Vec3 rest = vessel.surface.points.row(corner[k]);
      EXPECT_LT((Vec3(carried.row(corner[k])) - motion * rest).norm(), 1e-9) << rest.transpose();
      ++border;
    }
  }
  EXPECT_GT(border, 300);
  const auto reach = fork_reach(vessel);
  const auto places = element_places(rod);
  size_t far = 0;
  for (size_t v = 0; v < vessel.binding.size(); ++v) {
    const ElementPlace& at = places[static_cast<size_t>(vessel.binding[v].element)];
    const double s = at.start + vessel.binding[v].s;
    const ForkReach& mine = reach[at.branch];
    if (s < 3 * mine.start || mine.length - s < 3 * mine.end) continue;
    ++far;
    EXPECT_EQ(carried.row(static_cast<Eigen::Index>(v)),
              sections.row(static_cast<Eigen::Index>(v)));
  }
  EXPECT_GT(far, vessel.binding.size() / 3);
}

// Curvatures and twists of 0.01 per mm, radii up to 5, stretches of 0.8 %. With every vertex on its
// own section the walls tear. The arch's forks are a radius apart, where the wall between them
// takes three times the strain of the rod, and the arch vessels are thin beside it.
TEST(ForkReach, BentAndTwistedBranchesDoNotTear) {
  for (const char* name : {"pulmonary_artery", "aorta"}) {
    const Vessel vessel = fit_vessel(name, testing::infant(name));
    const RodPoses poses = branches_bent(vessel.rod, 0.04);
    const auto [least, largest] =
        testing::edge_ratios(vessel.surface.triangles, vessel.surface.points,
                             carried_points(vessel.rod, poses, vessel.carry));
    const auto torn = testing::edge_ratios(vessel.surface.triangles, vessel.surface.points,
                                           carried_points(vessel.rod, poses, vessel.binding));
    EXPECT_GT(least, 0.75) << name;
    EXPECT_LT(largest, 1.33) << name;
    EXPECT_LT(torn[0], 0.6) << name;
    EXPECT_GT(torn[1], 1.5) << name;
  }
}

// The reach of the bundled pulmonary artery's fork: the side branch leaves a trunk of radius 3.5 at
// a right angle, with a radius of 3.3, so that its mouth takes about its radius along the trunk and
// its wall begins a radius of the trunk away, and further where the crotch is rounded.
TEST(ForkReach, IsAboutARadius) {
  const Vessel vessel = fit_vessel("pulmonary_artery", testing::infant("pulmonary_artery"));
  const auto reach = fork_reach(vessel);
  ASSERT_EQ(reach.size(), 3U);
  EXPECT_EQ(reach[0].start, 0);
  EXPECT_NEAR(reach[0].end, 3.3, 0.7);
  EXPECT_NEAR(reach[1].start, 3.3, 0.7);
  EXPECT_EQ(reach[1].end, 0);
  EXPECT_GT(reach[2].start, 3.5);
  EXPECT_LT(reach[2].start, 2 * 3.5);
  EXPECT_EQ(reach[2].end, 0);
  const auto at_fork = fork_elements(vessel);
  const RodBranch& side = vessel.rod.branches[2];
  EXPECT_TRUE(at_fork[static_cast<size_t>(side.elements.front())]);
  EXPECT_FALSE(at_fork[static_cast<size_t>(side.elements.back())]);
  EXPECT_TRUE(branches_within_forks(vessel).empty());
}

// The arch of the aorta between its branches: forks a radius apart.
TEST(ForkReach, BranchesBetweenNearForksAreNamed) {
  const Vessel vessel = fit_vessel("aorta", testing::infant("aorta"));
  const auto reach = fork_reach(vessel);
  const auto within = branches_within_forks(vessel);
  EXPECT_FALSE(within.empty());
  for (const size_t b : within)
    EXPECT_LT(reach[b].length, 2 * (reach[b].start + reach[b].end)) << b;
  for (size_t b = 0; b < reach.size(); ++b) {
    const bool is_long = reach[b].length > 3 * (reach[b].start + reach[b].end);
    EXPECT_LE(std::count(within.begin(), within.end(), b), is_long ? 0 : 1) << b;
  }
}

}  // namespace
}  // namespace vasorod
