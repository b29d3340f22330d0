// The certificate compared with closed forms: it changes sign where columns, twisted rods and rings
// buckle. Buckled states are found from the saddle.
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "rod/elimination.h"
#include "rod/newton.h"
#include "rod/rods.h"

namespace vasorod {
namespace {

constexpr double pi = std::numbers::pi;
const Pose along_x = frame({0, 0, 0}, {1, 0, 0}, {0, 1, 0});

RodSolution column(double ea, double ga, double force, bool leave_saddle) {
  const RodTree tree = chain(along_x, 1, Vec3::Zero(), 64, isotropic(ga, ea, 1, 1));
  RodConditions conditions;
  conditions.supports = {clamp(0)};
  conditions.loads = {{64, {-force, 0, 0}, Vec3::Zero(), false}};
  RodOptions options;
  options.leave_saddle = leave_saddle;
  return solve_rod(tree, conditions, options);
}

TEST(Stability, EulerColumnWithShearAndStretch) {  // Haringx
  const double inf = 1e9;
  for (const auto& [ea, ga, critical] : {std::array{inf, inf, 2.467401100},
                                         {1e4, inf, 2.468010208},
                                         {inf, 100., 2.409351360},
                                         {200., 100., 2.437689451},
                                         {50., 20., 2.307644418}}) {
    const RodSolution below = column(ea, ga, 0.99 * critical, false),
                      above = column(ea, ga, 1.01 * critical, false);
    EXPECT_EQ(below.summary.status, Status::converged) << ea << ' ' << ga;
    EXPECT_EQ(above.summary.status, Status::unstable) << ea << ' ' << ga;
    EXPECT_EQ(above.summary.negative_directions, 2);  // in both lateral directions
  }
}

TEST(Stability, BuckledColumnFromTheStraightSaddle) {  // elliptic integrals
  for (const auto& [ratio, x, y] : {std::array{1.01539687, .96973091, .21941304},
                                    {1.06366327, .88120351, .42224034},
                                    {1.15171962, .74101961, .59320765},
                                    {1.29388932, .55939592, .71949710},
                                    {1.51838879, .34898930, .79153950},
                                    {1.88480087, .12315997, .80317099},
                                    {2.54225837, -.10692324, .75038837},
                                    {4.03008597, -.34031886, .62460351}}) {
    const RodSolution s = column(1e8, 1e8, ratio * pi * pi / 4, true);
    // the choice of the buckling plane costs no energy
    EXPECT_EQ(s.summary.status, Status::converged) << ratio;
    EXPECT_EQ(s.summary.neutral_directions, 1);
    EXPECT_EQ(s.summary.negative_directions, 0);
    const Vec3 tip = s.poses.back().position;
    // near the critical load the amplitude is the root of a small difference: a load error of 2e-4
    // becomes 0.8 % of the amplitude
    const double tolerance = ratio < 1.03 ? 4e-3 : 1e-3;
    EXPECT_NEAR(tip.x(), x, tolerance) << ratio;
    EXPECT_NEAR(std::hypot(tip.y(), tip.z()), y, tolerance) << ratio;
  }
}

TEST(Stability, TwistedClampedRodUnderTension) {  // shooting; T = 0: twice the root of tan x = x
  for (const auto& [tension, critical] : {std::array{-30., 3.800430},
                                          {-20., 5.771136},
                                          {-10., 7.451016},
                                          {-5., 8.232811},
                                          {0., 8.986818916},
                                          {5., 9.717748},
                                          {10., 10.428856},
                                          {20., 11.800330},
                                          {40., 14.375227},
                                          {60., 16.757735},
                                          {100., 20.983501},
                                          {200., 28.982738},
                                          {400., 40.496233}}) {
    const RodTree tree = chain(along_x, 1, Vec3::Zero(), 64, isotropic(1e7, 1e7, 1, 0.8));
    for (const double factor : {0.99, 1.01}) {
      RodConditions conditions;
      conditions.supports = {clamp(0), clamp(64)};
      conditions.supports[1].fixed = {true, true, false, true, true, false};  // slides and spins
      conditions.loads = {{64, {tension, 0, 0}, {factor * critical, 0, 0}, false}};
      RodOptions options;
      options.leave_saddle = false;
      const RodSolution s = solve_rod(tree, conditions, options);
      EXPECT_EQ(s.summary.status, factor < 1 ? Status::converged : Status::unstable)
          << tension << ' ' << factor;
      EXPECT_NEAR(s.stress[30][5], factor * critical, 1e-9);
    }
  }
}

// A tube with held ends whose lumen pushes with P: 4 pi^2 EI / L^2 = P (1 + P / GA) (Haringx 1948),
// as the wall between held ends is not shortened.
RodTree pressed_tube(double thrust, const Vec6& stiffness) {
  RodTree tree = chain(along_x, 1, Vec3::Zero(), 64, stiffness);
  for (RodElement& e : tree.elements) e.lumen[2] = thrust;
  return tree;
}

double haringx(double ga) {
  const double euler = 4 * pi * pi;
  return ga / 2 * (std::sqrt(1 + 4 * euler / ga) - 1);
}

TEST(Stability, PressureBowsAHeldTube) {
  for (const double ga : {50., 400., 1e6})
    for (const double factor : {0.99, 1.01}) {
      const RodTree tree = pressed_tube(factor * haringx(ga), isotropic(ga, 2000, 1, 0.8));
      RodConditions conditions;
      conditions.supports = {clamp(0), clamp(64)};
      RodOptions options;
      options.leave_saddle = false;
      const RodSolution s = solve_rod(tree, conditions, options);
      EXPECT_EQ(s.summary.status, factor < 1 ? Status::converged : Status::unstable)
          << ga << ' ' << factor;
      EXPECT_NEAR(s.stress[30][2], -factor * haringx(ga), 1e-9);
      EXPECT_NEAR(s.summary.energy, 0, 1e-20) << "the wall is at ease";
    }
}

// Beyond it the tube bows until its wall's tension takes up what is above the critical thrust.
TEST(Stability, ABowedTubeKeepsTheCriticalThrust) {
  for (const double ea : {1000., 1e5}) {
    const double ga = 1e6;
    const RodTree tree = pressed_tube(1.05 * haringx(ga), isotropic(ga, ea, 1, 0.8));
    RodConditions conditions;
    conditions.supports = {clamp(0), clamp(64)};
    const RodSolution s = solve_rod(tree, conditions);
    EXPECT_EQ(s.summary.status, Status::converged) << ea << ' ' << s.summary.message;
    const Vec3 middle = s.poses[32].position;
    const double bow = std::hypot(middle.y(), middle.z());
    // mean stretch of w = bow (1 - cos 2 pi x) / 2
    EXPECT_NEAR(ea * bow * bow * pi * pi / 4, 0.05 * haringx(ga), 0.05 * 0.05 * haringx(ga)) << ea;
  }
}

TEST(Stability, TwistedRing) {  // Zajac 1962: 2 pi sqrt(3) EI / GJ
  for (const double gj : {0.587, 2. / 3, 1.}) {
    const double ga = 1e6;
    for (const double factor : {0.99, 1.01}) {
      // Drawn as the ring, with sections without twist; the unstressed shape is straight and
      // twisted back. The rod has no preferred direction, so the ring can rotate about its tangent
      // at the clamp while the sections roll back. This is a symmetry of the scene and does not
      // count as negative.
      const double tau = factor * std::sqrt(3.) / gj;
      RodTree tree = chain(along_x, 2 * pi, {0, 1, 0}, 64, isotropic(ga, ga, 1, gj));
      for (RodElement& e : tree.elements) e.natural_strain << 0, 0, 1, 0, 0, -tau;
      RodConditions conditions;
      conditions.supports = {clamp(0), clamp(64)};
      RodOptions options;
      options.leave_saddle = false;
      const RodSolution s = solve_rod(tree, conditions, options);
      // the ring is the equilibrium, up to the error of 64 elements and the free rotation
      EXPECT_NEAR(s.summary.energy, pi * (1 + gj * tau * tau), 2e-3 * s.summary.energy);
      EXPECT_NEAR((s.poses[32].position - s.poses[0].position).norm(), 2, 0.02);
      EXPECT_EQ(s.summary.neutral_directions, 1) << gj << ' ' << factor;
      EXPECT_EQ(s.summary.negative_directions, factor < 1 ? 0 : 2) << gj << ' ' << factor;
      EXPECT_EQ(s.summary.status, factor < 1 ? Status::converged : Status::unstable)
          << gj << ' ' << factor;
    }
  }
}

// Ball joints and a dead axial moment at both ends: (M / 2 EI)^2 = (pi / L)^2 + T / EI. There is no
// energy and thus no certificate. The tangent is singular there, so the response to a lateral force
// changes sign.
TEST(Stability, GreenhillTangentIsSingular) {
  for (const double tension : {0., 10., -5.}) {
    const double critical = 2 * std::sqrt(pi * pi + tension);
    double answer[2];
    for (const int side : {0, 1}) {
      const double moment = (side == 0 ? 0.99 : 1.01) * critical;
      const RodTree tree = chain(Pose{}, 1, Vec3::Zero(), 64, isotropic(1e7, 1e7, 1, 1));
      std::vector<RodLink> links;
      std::vector<Vec6> strain, stress;
      for (const RodElement& e : tree.elements) {
        RodLink link;
        link.parent = e.first;
        link.length = e.length;
        link.natural = e.length * vec6(0, 0, 1, 0, 0, 0);
        link.stiffness = e.stiffness / e.length;
        links.push_back(link);
        stress.push_back(vec6(0, 0, tension, 0, 0, moment));
        strain.push_back(link.natural + e.length * vec6(0, 0, tension / 1e7, 0, 0, 0));
      }
      std::vector<NodeCondition> conditions(3);
      conditions[0].node = 0;
      conditions[0].fixed = {true,  true,  true,
                             false, false, true};  // its spin held: no moment comes of it
      conditions[0].space_moment = {0, 0, -moment};
      conditions[1].node = 64;
      conditions[1].fixed = {true, true, false, false, false, false};
      conditions[1].force = {0, 0, tension};
      conditions[1].space_moment = {0, 0, moment};
      conditions[2].node = 32;
      conditions[2].force = {1e-3, 0, 0};
      std::vector<Pose> poses(65);
      for (int i = 1; i <= 64; ++i) {
        poses[index(i)] = poses[index(i - 1)] * exp_motion(strain[0]);
        poses[index(i)].rotation = Mat3::Identity();
      }
      for (NodeCondition& c : conditions) {
        c.target = poses[index(c.node)];
        c.carried << 0, 0,
            c.node == 64  ? tension
            : c.node == 0 ? -tension
                          : 0,
            0, 0,
            c.node == 64  ? moment
            : c.node == 0 ? -moment
                          : 0;
      }
      RodElimination elimination(links, conditions);
      elimination.factor(poses, strain, stress);
      std::vector<Vec6> step, next, stretch;
      elimination.solve(step, next, stretch);
      answer[side] = step[32][0];
    }
    EXPECT_GT(answer[0] * 1e3, 1. / 48)
        << tension;  // more than for a beam without moment: EI = L = 1, 1/48
    EXPECT_LT(answer[1], 0) << tension;
  }
}

TEST(Stability, TwoCoilHelixBetweenClampsIsASaddle) {
  const double c = 50 / (2 * pi * 10 * 2), kappa = 0.1 / (1 + c * c), tau = c * kappa,
               length = 135.24558048876;
  for (const int n : {32, 64}) {
    // naturally straight, drawn as the helix, held at both ends; stiffness of slenderness 1e2, E =
    // 1
    const double d = length / 100, ei = pi * std::pow(d, 4) / 64, ea = pi * d * d / 4;
    RodTree tree = chain(along_x, length, {0, kappa, tau}, n, isotropic(ea / 2, ea, ei, ei));
    for (RodElement& e : tree.elements) e.natural_strain << 0, 0, 1, 0, 0, 0;
    RodConditions conditions;
    conditions.supports = {clamp(0), clamp(n)};
    RodOptions options;
    options.leave_saddle = false;
    const RodSolution s = solve_rod(tree, conditions, options, &tree.rest);
    EXPECT_EQ(s.summary.status, Status::unstable);
    EXPECT_EQ(s.summary.negative_directions, 2) << n;
    EXPECT_LT(s.summary.residual, 1e-9);
    EXPECT_NEAR(s.summary.energy, 0.0958801882209, 1e-10);
  }
}

TEST(Stability, OneCoilAlongItsPathIsAMinimum) {
  const double c = 50 / (2 * pi * 10 * 2), kappa = 0.1 / (1 + c * c), tau = c * kappa,
               length = 135.24558048876 / 2;
  const double d = length / 50, ei = pi * std::pow(d, 4) / 64, ea = pi * d * d / 4;
  const int n = 32;
  const RodTree straight = chain(along_x, length, Vec3::Zero(), n, isotropic(ea / 2, ea, ei, ei));
  RodConditions conditions;
  RodPoses poses = straight.rest;
  RodSolution s;
  for (int step = 1; step <= 16;
       ++step) {  // moves the end along helices with a share of the strain
    const double t = step / 16.;
    const Pose end = along_x * exp_motion(length * vec6(0, 0, 1, 0, t * kappa, t * tau));
    conditions.supports = {clamp(0), clamp_at(straight, n, end)};
    s = solve_rod(straight, conditions, {}, &poses);
    ASSERT_EQ(s.summary.status, Status::converged) << t;
    poses = s.poses;
  }
  EXPECT_NEAR(s.summary.energy, length / 2 * ei * (tau * tau + kappa * kappa),
              1e-9 * s.summary.energy);
  const Pose middle = along_x * exp_motion(length / 2 * vec6(0, 0, 1, 0, kappa, tau));
  EXPECT_LT((s.poses[n / 2].position - middle.position).norm(), 1e-8 * length);
}

}  // namespace
}  // namespace vasorod
