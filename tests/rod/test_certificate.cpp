// The solver's statements about an equilibrium: lowest modes, symmetries of the scene, best states.
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "rod/certificate.h"
#include "rod/energy.h"
#include "rod/newton.h"
#include "rod/rods.h"

namespace vasorod {
namespace {

constexpr double pi = std::numbers::pi;
const Pose along_x = frame({0, 0, 0}, {1, 0, 0}, {0, 1, 0});

struct Column {
  RodTree tree;
  RodConditions conditions;
  Column(double force, const Vec6& stiffness, bool far_end_held) {
    tree = chain(along_x, 1, Vec3::Zero(), 32, stiffness);
    conditions.supports = {clamp(0)};
    if (far_end_held) {
      conditions.supports.push_back(clamp(32));
      conditions.supports[1].fixed[2] = false;  // slides along d3
    }
    conditions.loads = {{32, {-force, 0, 0}, Vec3::Zero(), false}};
  }
};

// z^T H z / z^T M z by the element's own Hessian; M contains the lengths at each node. In (r,
// omega) about a straight rod's axis, dead forces contribute only their bracket term F.(omega x
// v)/2, which the elimination contains too.
double rayleigh(const RodTree& tree, const RodPoses& poses, const std::vector<Vec6>& stress,
                const RodStep& mode) {
  double up = 0, weight = 0;
  for (std::size_t e = 0; e < tree.elements.size(); ++e) {
    const RodElement& element = tree.elements[e];
    const Pose &first = poses[index(element.first)], &second = poses[index(element.second)];
    const Vec6 &a = mode.twist[index(element.first)], &b = mode.twist[index(element.second)];
    Vec12 eta;
    eta << first.rotation.transpose() * a.head<3>(), first.rotation.transpose() * a.tail<3>(),
        second.rotation.transpose() * b.head<3>(), second.rotation.transpose() * b.tail<3>();
    up += eta.dot(element_energy_hessian(element, first, second, stress[e]) * eta);
    weight += 0.5 * element.length * (a.squaredNorm() + b.squaredNorm());
  }
  return up / weight;
}

TEST(Certificate, TheLowestModeIsTheBucklingMode) {
  for (const bool held : {false, true}) {
    // unit length and bending stiffness: the solver's scaled units are these
    const double critical = held ? 4 * pi * pi : pi * pi / 4;
    const Column column(1.05 * critical, isotropic(1e7, 1e7, 1, 1), held);
    RodProblem problem(column.tree, column.conditions);
    RodState state = problem.state_at(column.tree.rest);
    for (Vec6& s : state.stress) s[2] = -1.05 * critical;
    EXPECT_EQ(certify(problem, state).negative, 2);  // in both lateral directions
    const RodStep mode = lowest_mode(problem, state);
    double force_term = 0, weight = 0;  // second-order work of the dead force in these coordinates
    for (std::size_t k = 0; k < mode.twist.size(); ++k)
      weight += problem.elimination().weight(static_cast<int>(k)) * mode.twist[k].squaredNorm();
    if (!held)
      force_term = -Vec3(-1.05 * critical, 0, 0)
                        .dot(mode.twist[32].tail<3>().cross(mode.twist[32].head<3>())) /
                   weight;
    EXPECT_LT(rayleigh(column.tree, column.tree.rest, state.stress, mode) + force_term, 0) << held;
    // lateral everywhere, largest where the closed form is largest
    const std::size_t largest = held ? 16 : 32;
    for (const Vec6& t : mode.twist) {
      EXPECT_LE(t.segment<2>(1).norm(), mode.twist[largest].segment<2>(1).norm() * (1 + 1e-9));
      EXPECT_LT(std::abs(t[0]), 1e-6 * mode.size());
    }
    const double shape =
        mode.twist[8].segment<2>(1).norm() / mode.twist[largest].segment<2>(1).norm();
    EXPECT_NEAR(shape, held ? 0.5 : 1 - std::cos(pi / 8),
                2e-3);  // (1 - cos 2 pi s)/2 and 1 - cos(pi s / 2), s = 1/4
  }
}

TEST(Certificate, ABuckledColumnIsOneOfAFamily) {
  const Column column(1.3 * pi * pi / 4, isotropic(1e8, 1e8, 1, 0.7), false);
  const RodSolution s = solve_rod(column.tree, column.conditions);
  EXPECT_EQ(s.summary.status, Status::converged);
  EXPECT_EQ(s.summary.negative_directions, 0);
  EXPECT_EQ(s.summary.neutral_directions, 1);
  EXPECT_NE(s.summary.message.find("rotation about the axis"), std::string::npos)
      << s.summary.message;
  EXPECT_NE(s.summary.message.find("while the sections turn back"), std::string::npos);
}

TEST(Certificate, AnUnequalColumnIsNot) {  // it buckles in its weak plane, in both directions
  const Column column(1.3 * pi * pi / 4, vec6(1e8, 1e8, 1e8, 1, 2, 0.7), false);
  const RodSolution s = solve_rod(column.tree, column.conditions);
  EXPECT_EQ(s.summary.status, Status::converged);
  EXPECT_EQ(s.summary.neutral_directions, 0);
  EXPECT_EQ(s.summary.message, "");
}

TEST(Certificate, ATwistedRodBesideItsAxisIsOneOfAFamily) {
  const RodTree tree = chain(Pose{}, 1, Vec3::Zero(), 48, isotropic(4e3, 1e4, 1, 0.8));
  RodConditions conditions;
  conditions.supports = {clamp(0), clamp(48)};
  conditions.supports[1].motion = {{0, 0, 2 * pi}, {0, 0, -.1}};
  const RodSolution s = solve_rod(tree, conditions);
  EXPECT_EQ(s.summary.status, Status::converged) << s.summary.message;
  EXPECT_EQ(s.summary.neutral_directions, 1);
  EXPECT_GT(s.poses[24].position.head<2>().norm(), 0.1);
}

TEST(Certificate,
     ARodBetweenBallJointsIsOneOfAFamily) {  // unequal bending stiffness: it turns as a whole
  const RodTree tree = chain(along_x, 1, Vec3::Zero(), 8, vec6(1e4, 1e4, 1e4, 1, 2, 1));
  RodConditions conditions;
  conditions.supports = {clamp(0), clamp(8)};
  for (RodSupport& s : conditions.supports) s.fixed = {true, true, true, false, false, false};
  const RodSolution free = solve_rod(tree, conditions);
  EXPECT_EQ(free.summary.status, Status::converged);
  EXPECT_EQ(free.summary.neutral_directions, 1);
  EXPECT_NE(free.summary.message.find("rotation about the axis"), std::string::npos)
      << free.summary.message;
}

// A straight rod closed to a ring can roll about its tangent without energy. Sections with a weaker
// shear direction have no symmetry, and the ring has no shear: a zero-energy mode without a
// symmetry.
TEST(Certificate, ADirectionThatCostsNothingWithoutASymmetryIsNotCalledAMinimum) {
  for (const double second : {1e6, 2e6}) {
    RodTree tree = chain(along_x, 2 * pi, {0, 1, 0}, 64, vec6(1e6, second, 1e6, 1, 1, 0.7));
    for (RodElement& e : tree.elements) e.natural_strain << 0, 0, 1, 0, 0, 0;
    RodConditions conditions;
    conditions.supports = {clamp(0), clamp(64)};
    const RodSolution s = solve_rod(tree, conditions);
    EXPECT_EQ(s.summary.neutral_directions, 1) << second;
    EXPECT_EQ(s.summary.negative_directions, 0) << second;
    EXPECT_EQ(s.summary.status, second == 1e6 ? Status::converged : Status::equilibrium_only)
        << s.summary.message;
  }
}

TEST(Certificate, AnInterruptedSolveReturnsTheBestState) {
  const RodTree tree = chain(along_x, 1, Vec3::Zero(), 32, isotropic(4.8e6, 1.2e7, 1, .8));
  RodConditions conditions;
  conditions.supports = {clamp(0), clamp(32)};
  conditions.supports[1].motion = {Vec3(1, 1, .3).normalized() * (pi / 3), {-.2, .1, .05}};
  const int all = solve_rod(tree, conditions).summary.iterations;
  double before = std::numeric_limits<double>::infinity();
  for (int limit = 1; limit < all; ++limit) {
    RodOptions options;
    int asked = 0;
    options.stop = [&] { return ++asked > limit; };
    const RodSolution s = solve_rod(tree, conditions, options);
    ASSERT_EQ(s.summary.status, Status::interrupted) << limit;
    for (const Pose& p : s.poses) ASSERT_TRUE(p.position.allFinite() && p.rotation.allFinite());
    EXPECT_TRUE(std::isfinite(s.summary.residual));
    if (limit + 3 >= all) {  // in Newton's last steps: never worse than the previous step
      EXPECT_LE(s.summary.residual, before) << limit;
      before = s.summary.residual;
    }
  }
}

}  // namespace
}  // namespace vasorod
