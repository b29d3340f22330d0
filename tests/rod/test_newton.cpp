#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include <vasorod/error.h>

#include "rod/newton.h"
#include "rod/rods.h"

namespace vasorod {
namespace {

constexpr double pi = std::numbers::pi;

RodSolution solve_bend45(int elements, double force) {
  const RodTree tree = bend45(elements, isotropic(5e6, 1e7, 1e7 / 12, 833333.3));
  RodConditions conditions;
  conditions.supports = {clamp(0)};
  conditions.loads = {{elements, {0, 0, force}, Vec3::Zero(), false}};
  return solve_rod(tree, conditions);
}

TEST(Newton,
     Bend45ConvergesAtOrderTwo) {  // Bathe & Bolourchi 1979; digits by an 8th-order shooting solver
  const Vec3 exact(15.684800534, 47.150438574, 53.474858792);
  double error[3];
  int i = 0;
  for (const int n : {32, 64, 128}) {
    const RodSolution s = solve_bend45(n, 600);
    EXPECT_EQ(s.summary.status, Status::converged);
    EXPECT_LE(s.summary.iterations, 8);
    EXPECT_LT((s.reactions[0].force - Vec3(0, 0, -600)).norm(), 1e-9);
    error[i++] = (s.poses.back().position - exact).norm();
  }
  EXPECT_LT(error[0], 1.04e-2);
  EXPECT_LT(error[2], 6.6e-4);
  EXPECT_NEAR(std::log2(error[0] / error[1]), 2, 0.05);
  EXPECT_NEAR(std::log2(error[1] / error[2]), 2, 0.05);
}

// A straight rod pulled by a dead force along its axis is a linear problem: the first step solves
// it, the second finds nothing left, and the certificate factorises once more.
TEST(Newton, CountsOfALinearProblemAreKnown) {
  const RodTree tree =
      chain(frame({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), 1, {0, 0, 0}, 40, isotropic(100, 250, 1, 0.8));
  RodConditions conditions;
  conditions.supports = {clamp(0)};
  conditions.loads = {{40, {1, 0, 0}, Vec3::Zero(), false}};
  const RodSummary summary = solve_rod(tree, conditions).summary;
  EXPECT_EQ(summary.status, Status::converged);
  EXPECT_EQ(summary.iterations, 2);
  EXPECT_EQ(summary.counts, (Counts{.factorisations = 3, .solves = 2}));
}

TEST(Newton, PrescribedEndPose) {  // case B12, 60 degrees, slenderness 1e3, second order in h
  const double r = 12e6;
  const RodTree tree =
      chain(frame({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), 1, {0, 0, 0}, 128, isotropic(.4 * r, r, 1, .8));
  RodConditions conditions;
  conditions.supports = {clamp(0), clamp(128)};
  conditions.supports[1].motion.rotate = Vec3(1, 1, 0.3).normalized() * pi / 3;
  conditions.supports[1].motion.move = Vec3(-.2, .1, .05);
  const RodSolution s = solve_rod(tree, conditions);
  EXPECT_EQ(s.summary.status, Status::converged);
  EXPECT_LT((s.poses[64].position - Vec3(0.41678141, -0.09399874, 0.23689195)).norm(), 1e-5);
  EXPECT_NEAR(s.summary.energy, 4.975051418, 1e-3);
  EXPECT_LT((s.reactions[0].force + s.reactions[1].force).norm(),
            1e-6 * s.reactions[0].force.norm());
  const Pose target = target_pose(tree, conditions.supports[1]);
  EXPECT_LT((s.poses.back().position - target.position).norm(), 1e-15);
  // warm start at the solution: nothing remains to be done; with the end moved further: the same
  // answer as from rest
  EXPECT_LE(solve_rod(tree, conditions, {}, &s.poses).summary.iterations, 2);
  conditions.supports[1] = clamp_at(
      tree, 128,
      {exp_rotation({0.05, 0.1, 0}) * target.rotation, target.position + Vec3(0.02, 0, -0.03)});
  const RodSolution warm = solve_rod(tree, conditions, {}, &s.poses),
                    cold = solve_rod(tree, conditions);
  EXPECT_EQ(warm.summary.status, Status::converged);
  EXPECT_LT((warm.poses[64].position - cold.poses[64].position).norm(), 1e-7);
}

TEST(Newton, RollUpIsExactWithThreeElements) {  // B5
  const RodTree tree = chain(Pose{}, 1, Vec3::Zero(), 3, isotropic(1e4, 1e4, 1, 1));
  RodConditions conditions;
  conditions.supports = {clamp(0)};
  conditions.loads = {{3, Vec3::Zero(), {0, 2 * pi, 0}, true}};
  const RodSolution s = solve_rod(tree, conditions);
  EXPECT_EQ(s.summary.status, Status::equilibrium_only);
  EXPECT_LT(s.poses.back().position.norm(), 1e-12);
  EXPECT_NEAR(s.summary.energy, 2 * pi * pi, 1e-11);
}

TEST(Newton, RefusesWhatCannotBe) {
  const RodTree good = chain(Pose{}, 1, Vec3::Zero(), 4, isotropic(1, 1, 1, 1));
  const auto sentence = [](const RodTree& tree, const RodConditions& conditions) -> std::string {
    try {
      solve_rod(tree, conditions);
    } catch (const InputError& e) {
      return e.what();
    }
    return "";
  };
  RodConditions loaded;
  loaded.loads = {{4, {1, 0, 0}, Vec3::Zero(), false}};
  EXPECT_NE(sentence(good, loaded).find("rigid motion that no support stops: "), std::string::npos);
  loaded.supports = {clamp(0)};
  EXPECT_EQ(sentence(good, loaded), "");
  loaded.supports[0].fixed = {true, true, true, false, false, false};
  EXPECT_NE(sentence(good, loaded).find("rotation about the axis (0, 1, 0) through (0, 0, 0)"),
            std::string::npos);
  loaded.supports = {clamp(0)};
  RodTree bad = good;
  bad.elements[2].length = 0;
  EXPECT_NE(sentence(bad, loaded).find("element 2 has length 0"), std::string::npos);
  bad = good;
  bad.elements[1].stiffness(3, 3) = -1;
  EXPECT_NE(sentence(bad, loaded).find("element 1 has a stiffness that is not positive definite"),
            std::string::npos);
  bad = good;
  bad.rest[2].rotation *= 1.1;
  EXPECT_NE(sentence(bad, loaded).find("frame of node 2 is not right-handed and orthonormal"),
            std::string::npos);
  bad = good;
  bad.elements[3].first = 4;
  bad.elements[3].second = 1;
  EXPECT_NE(sentence(bad, loaded).find("two elements lead into node 1"), std::string::npos);
  bad = good;
  bad.elements[1].first = 3;
  EXPECT_NE(sentence(bad, loaded).find("not connected to the root"), std::string::npos);
  bad = good;
  bad.elements.push_back(bad.elements[0]);
  EXPECT_NE(sentence(bad, loaded).find("without closed loops"), std::string::npos);
}

}  // namespace
}  // namespace vasorod
