// Invariance: placement of the scene, unit of stress, path to the end state (case B14).
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "rod/newton.h"
#include "rod/rods.h"
#include "rod/strains.h"

namespace vasorod {
namespace {

constexpr double pi = std::numbers::pi;

// B12, 60 degrees, slenderness 1e3.
RodTree straight(int elements, double modulus = 1) {
  return chain(frame({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), 1, Vec3::Zero(), elements,
               modulus * isotropic(.4 * 12e6, 12e6, 1, .8));
}
RodConditions moved_end(int elements) {
  RodConditions conditions;
  conditions.supports = {clamp(0), clamp(elements)};
  conditions.supports[1].motion = {Vec3(1, 1, 0.3).normalized() * pi / 3, {-.2, .1, .05}};
  return conditions;
}

TEST(Invariance, ARigidMotionOfTheWholeSceneChangesNoStrain) {
  const RodTree tree = straight(32);
  const RodConditions conditions = moved_end(32);
  const RodSolution here = solve_rod(tree, conditions);
  ASSERT_EQ(here.summary.status, Status::converged);
  const std::vector<Vec6> strains = element_strains(tree, here.poses);
  for (const Vec6& twist :
       {vec6(3, -2, 5, 0.4, 1.1, -2.0), vec6(-40, 7, 1, 0, 0, 3.0), vec6(0, 0, 0, 1.7, 0, 0)}) {
    const Pose g = exp_motion(twist);
    RodTree there = tree;
    for (Pose& p : there.rest) p = g * p;
    RodConditions turned = conditions;
    turned.supports[1].motion.rotate = g.rotation * conditions.supports[1].motion.rotate;
    turned.supports[1].motion.move = g.rotation * conditions.supports[1].motion.move;
    const RodSolution s = solve_rod(there, turned);
    EXPECT_EQ(s.summary.status, Status::converged);
    EXPECT_NEAR(s.summary.energy, here.summary.energy, 1e-12 * here.summary.energy);
    const std::vector<Vec6> same = element_strains(there, s.poses);
    // a strain is a difference of positions over a length: 1e-12 times the round-off of coordinates
    // of 45
    const double round_off = 1e-12 * std::max(1., g.position.norm());
    for (std::size_t e = 0; e < same.size(); ++e)
      EXPECT_LT((same[e] - strains[e]).norm(), round_off) << e;
    EXPECT_LT((s.reactions[0].force - g.rotation * here.reactions[0].force).norm(),
              1e-9 * here.reactions[0].force.norm());
  }
}

TEST(Invariance,
     TheEndMotionCanBeMadeByTheClampInstead) {  // objectivity by a motion of the supports
  const RodTree tree = straight(32);
  const RodSolution here = solve_rod(tree, moved_end(32));
  const Pose g = exp_motion(vec6(0.3, -0.2, 0.5, 0.4, 0.9, -0.6));
  RodConditions both;
  both.supports = {clamp_at(tree, 0, g * tree.rest[0]),
                   clamp_at(tree, 32, g * target_pose(tree, moved_end(32).supports[1]))};
  const RodSolution there = solve_rod(tree, both);
  EXPECT_EQ(there.summary.status, Status::converged);
  EXPECT_NEAR(there.summary.energy, here.summary.energy, 1e-12 * here.summary.energy);
  const std::vector<Vec6> strains = element_strains(tree, here.poses),
                          same = element_strains(tree, there.poses);
  for (std::size_t e = 0; e < same.size(); ++e)
    EXPECT_LT((same[e] - strains[e]).norm(), 1e-12) << e;
  for (std::size_t i = 0; i < here.poses.size(); ++i)
    EXPECT_LT((there.poses[i].position - g * here.poses[i].position).norm(), 1e-12) << i;
}

TEST(Invariance, ACommonFactorOfAllModuliScalesForcesAlone) {
  const RodSolution base = solve_rod(straight(32), moved_end(32));
  for (const double factor : {1e-6, 1e-3, 1e3, 1e6}) {
    const RodSolution s = solve_rod(straight(32, factor), moved_end(32));
    EXPECT_EQ(s.summary.status, Status::converged);
    EXPECT_EQ(s.summary.iterations, base.summary.iterations) << factor;
    EXPECT_NEAR(s.summary.energy / factor, base.summary.energy, 1e-12 * base.summary.energy)
        << factor;
    for (std::size_t i = 0; i < s.poses.size(); ++i)
      EXPECT_LT((s.poses[i].position - base.poses[i].position).norm(), 1e-13) << factor << ' ' << i;
    EXPECT_LT((s.reactions[1].moment / factor - base.reactions[1].moment).norm(), 1e-10) << factor;
  }
}

TEST(Invariance, TheUnitOfLengthChangesNoStrain) {
  for (const double size : {1e-6, 1e6}) {
    RodTree tree = straight(32);
    for (Pose& p : tree.rest) p.position *= size;
    for (RodElement& e : tree.elements) {
      e.length *= size;
      const Vec6 unit = vec6(1, 1, 1, size, size, size);  // forces stay, moments increase
      e.stiffness = (unit.asDiagonal() * e.stiffness * unit.asDiagonal()).eval();
    }
    RodConditions conditions = moved_end(32);
    conditions.supports[1].motion.move *= size;
    const RodSolution s = solve_rod(tree, conditions),
                      base = solve_rod(straight(32), moved_end(32));
    EXPECT_EQ(s.summary.status, Status::converged);
    for (std::size_t i = 0; i < s.poses.size(); ++i)
      EXPECT_LT((s.poses[i].position / size - base.poses[i].position).norm(), 1e-11)
          << size << ' ' << i;
  }
}

TEST(Invariance, TwoWaysToOneEnd) {
  const RodTree tree = straight(32);
  const RodConditions end = moved_end(32);
  const RodSolution direct = solve_rod(tree, end);
  RodOptions steps;
  steps.path_steps = 7;
  const RodSolution followed = solve_rod(tree, end, steps);
  // first the translation alone, then the rotation in addition, each from the previous state
  RodConditions first = end;
  first.supports[1].motion.rotate.setZero();
  first.supports[1].motion.move *= 0.5;
  const RodSolution half = solve_rod(tree, first);
  const RodSolution staged = solve_rod(tree, end, {}, &half.poses);
  for (const RodSolution* s : {&followed, &staged}) {
    EXPECT_EQ(s->summary.status, Status::converged);
    EXPECT_NEAR(s->summary.energy, direct.summary.energy, 1e-10 * direct.summary.energy);
    for (std::size_t i = 0; i < s->poses.size(); ++i)
      EXPECT_LT((s->poses[i].position - direct.poses[i].position).norm(), 1e-9) << i;
  }
}

TEST(Invariance, TwoLoadsInEitherOrder) {
  const RodTree tree = bend45(24, isotropic(5e6, 1e7, 1e7 / 12, 833333.3));
  RodConditions one, two, both;
  one.supports = two.supports = both.supports = {clamp(0)};
  one.loads = {{24, {0, 0, 400}, Vec3::Zero(), false}};
  two.loads = {{12, {100, -50, 0}, Vec3::Zero(), false}};
  both.loads = {one.loads[0], two.loads[0]};
  const RodSolution after_one = solve_rod(tree, one), after_two = solve_rod(tree, two);
  const RodSolution a = solve_rod(tree, both, {}, &after_one.poses),
                    b = solve_rod(tree, both, {}, &after_two.poses);
  EXPECT_EQ(a.summary.status, Status::converged);
  for (std::size_t i = 0; i < a.poses.size(); ++i)
    EXPECT_LT((a.poses[i].position - b.poses[i].position).norm(), 1e-9) << i;
}

}  // namespace
}  // namespace vasorod
