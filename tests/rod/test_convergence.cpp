// Orders of convergence, compared with closed forms and an independent shooting solver.
#include <array>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <numbers>

#include "data/index.h"
#include "rod/newton.h"
#include "rod/rods.h"

namespace vasorod {
namespace {

constexpr double pi = std::numbers::pi;
const Pose along_x = frame({0, 0, 0}, {1, 0, 0}, {0, 1, 0});

void expect_order(const std::function<double(int)>& error, double order, double tolerance) {
  double before = error(16);
  for (const int n : {32, 64, 128}) {
    const double now = error(n);
    EXPECT_NEAR(std::log2(before / now), order, tolerance) << n << ": " << before << " -> " << now;
    before = now;
  }
}

RodSolution elastica(int elements, double alpha, double stiff = 1e8) {
  RodTree tree = chain(along_x, 1, Vec3::Zero(), elements, isotropic(stiff, stiff, 1, 1));
  RodConditions conditions;
  conditions.supports = {clamp(0)};
  conditions.loads = {{elements, {0, alpha, 0}, Vec3::Zero(), false}};
  return solve_rod(tree, conditions);
}

TEST(Convergence, Elastica) {  // B1: Mattiasson 1981, EA L^2 / EI = 1e8
  struct Case {
    double alpha, w, u;
  };
  for (const Case& c : {Case{1, 0.3017207738, 0.0564332362834},
                        {5, 0.713791523612, 0.387628360724},
                        {10, 0.81060902488, 0.554995597754}})
    expect_order(
        [&](int n) {
          const RodSolution s = elastica(n, c.alpha);
          EXPECT_EQ(s.summary.status, Status::converged);
          EXPECT_LE(s.summary.iterations, 8) << c.alpha;
          return (s.poses.back().position - Vec3(1 - c.u, c.w, 0)).norm();
        },
        2, 0.05);
}

TEST(Convergence, ElasticaExtrapolatedIsOrderFour) {
  const auto error = [](int n) {  // EA L^2 / EI = 1e11: the digits are those of an inextensible rod
    const RodSolution a = elastica(n, 5, 1e11), b = elastica(2 * n, 5, 1e11);
    return ((4 * b.poses.back().position - a.poses.back().position) / 3 -
            Vec3(1 - 0.387628360724, 0.713791523612, 0))
        .norm();
  };
  double before = error(8);
  for (const int n : {16, 32}) {
    const double now = error(n);
    EXPECT_NEAR(std::log2(before / now), 4, 0.05) << n << ": " << before << " -> " << now;
    before = now;
  }
}

TEST(Convergence, ElasticaOfEveryTabulatedLoad) {
  for (const auto& [alpha, w, u, theta] :
       {std::array{0.5, 0.162143575658, 0.0159189624708, 0.244533647133},
        {1, 0.3017207738, 0.0564332362834, 0.461351949712},
        {2, 0.493457480397, 0.160641720825, 0.781749831557},
        {5, 0.713791523612, 0.387628360724, 1.21536811761},
        {10, 0.81060902488, 0.554995597754, 1.4302855388},
        {50, 0.917155447304, 0.80000039605, 1.56798190157}}) {
    // extrapolation from n and 2n has order four
    const RodSolution a = elastica(128, alpha, 1e10), b = elastica(256, alpha, 1e10);
    EXPECT_EQ(b.summary.status, Status::converged) << alpha;
    const Vec3 tip = (4 * b.poses.back().position - a.poses.back().position) / 3;
    const auto turn = [](const RodSolution& s) {
      const Vec3 d = s.poses.back().director(3);
      return std::atan2(d.y(), d.x());
    };
    const double tolerance = alpha > 20 ? 2e-6 : 2e-8;
    EXPECT_NEAR(tip.x(), 1 - u, tolerance) << alpha;
    EXPECT_NEAR(tip.y(), w, tolerance) << alpha;
    EXPECT_NEAR((4 * turn(b) - turn(a)) / 3, theta, tolerance) << alpha;
  }
}

TEST(Convergence, IterationsDoNotDependOnSlenderness) {
  for (int e = 1; e <= 6; ++e) {
    const double slenderness = std::pow(10, e);
    for (const double alpha : {0.5, 1., 2., 5., 10.}) {
      const RodSolution s = elastica(64, alpha, 12 * slenderness * slenderness);
      EXPECT_EQ(s.summary.status, Status::converged) << e << ' ' << alpha;
      EXPECT_LE(s.summary.iterations, 8) << e << ' ' << alpha;
    }
    // B7, width R / slenderness: F = 6e6 (w / 10)^4, E = 1e7
    const double w = 100 / slenderness, ei = 1e7 * std::pow(w, 4) / 12, ea = 1e7 * w * w;
    const RodTree tree = bend45(64, isotropic(ea / 2, ea, ei, ei));
    RodConditions conditions;
    conditions.supports = {clamp(0)};
    conditions.loads = {{64, {0, 0, 600 * std::pow(w, 4)}, Vec3::Zero(), false}};
    const RodSolution s = solve_rod(tree, conditions);
    EXPECT_EQ(s.summary.status, Status::converged) << e;
    EXPECT_LE(s.summary.iterations, 8) << e;
    if (e <= 4) {  // [C], n = 64: second order, 2.6e-3
      const Vec3 tips[] = {{15.657247969, 47.065665642, 54.095027011},
                           {15.684800534, 47.150438574, 53.474858792},
                           {15.685075386, 47.151285842, 53.468661045},
                           {15.685078134, 47.151294315, 53.468599068}};
      EXPECT_LT((s.poses.back().position - tips[e - 1]).norm(), 3e-3) << e;
      const double energies[] = {1.3033662601, 1.2834449270, 1.2832458903, 1.2832439000};
      EXPECT_NEAR(s.summary.energy * 100 / ei, energies[e - 1], 2e-4) << e;
    }
  }
}

TEST(Convergence, Bend45OfEveryTabulatedLoad) {
  struct Case {
    double ga, ea, force;
    Vec3 tip;
    double energy;
  };
  const double b = 5. / 6, kirchhoff = 1e12;
  for (const Case& c :
       {Case{5e6, 1e7, 300, {22.244780945, 58.779122490, 40.191891670}, 5055.03648},
        {5e6, 1e7, 450, {18.508178925, 52.238557838, 48.502927344}, 8113.81874},
        {5e6, 1e7, 600, {15.684800534, 47.150438574, 53.474858792}, 10695.37439},
        {5e6, 1e7, 3000, {4.232875917, 23.024308225, 68.539089493}, 30082.92566},
        {b * 5e6, 1e7, 300, {22.244679427, 58.778897330, 40.192392332}, 5055.08873},
        {b * 5e6, 1e7, 450, {18.508064876, 52.238261847, 48.503491532}, 8113.89455},
        {b * 5e6, 1e7, 600, {15.684689479, 47.150096240, 53.475477998}, 10695.47907},
        {kirchhoff, kirchhoff, 300, {22.245034742, 58.779685391, 40.188283838}, 5054.55243},
        {kirchhoff, kirchhoff, 600, {15.685078162, 47.151294315, 53.468598442}, 10693.69900}}) {
    RodSolution s[2];
    for (const int k : {0, 1}) {
      const RodTree tree = bend45(64 << k, isotropic(c.ga, c.ea, 1e7 / 12, 833333.3));
      RodConditions conditions;
      conditions.supports = {clamp(0)};
      conditions.loads = {{64 << k, {0, 0, c.force}, Vec3::Zero(), false}};
      s[k] = solve_rod(tree, conditions);
      EXPECT_EQ(s[k].summary.status, Status::converged) << c.force;
    }
    const Vec3 tip = (4 * s[1].poses.back().position - s[0].poses.back().position) / 3;
    const double tolerance = c.force > 1000 ? 1e-4 : 1e-6;
    EXPECT_LT((tip - c.tip).norm(), tolerance) << c.ga << ' ' << c.force;
    EXPECT_NEAR((4 * s[1].summary.energy - s[0].summary.energy) / 3, c.energy, 1e-5 * c.energy);
  }
}

TEST(Convergence, Bend45) {
  expect_order(
      [](int n) {
        const RodTree tree = bend45(n, isotropic(5e6, 1e7, 1e7 / 12, 833333.3));
        RodConditions conditions;
        conditions.supports = {clamp(0)};
        conditions.loads = {{n, {0, 0, 600}, Vec3::Zero(), false}};
        return (solve_rod(tree, conditions).poses.back().position -
                Vec3(15.684800534, 47.150438574, 53.474858792))
            .norm();
      },
      2, 0.05);
}

TEST(Convergence, PrescribedEndPoses) {  // B12
  struct Case {
    double degrees;
    Vec3 move;
    double slenderness, energy;
    Vec3 middle;
  };
  for (const Case& c :
       {Case{60, {-.2, .1, .05}, 1e2, 4.968969708, {0.41678651, -0.09390444, 0.23674919}},
        {60, {-.2, .1, .05}, 1e3, 4.975051418, {0.41678141, -0.09399874, 0.23689195}},
        {60, {-.2, .1, .05}, 1e4, 4.975112310, {0.41678136, -0.09399969, 0.23689338}},
        {120, {-.4, .2, .1}, 1e2, 9.361704850, {0.39869454, -0.17698886, 0.21032135}},
        {120, {-.4, .2, .1}, 1e3, 9.368806732, {0.3986925, -0.1770716, 0.21037551}},
        {120, {-.4, .2, .1}, 1e4, 9.368877827, {0.39869248, -0.17707243, 0.21037605}}}) {
    const double ea = 12 * c.slenderness * c.slenderness;
    const auto solve = [&](int n) {
      const RodTree tree = chain(along_x, 1, Vec3::Zero(), n, isotropic(.4 * ea, ea, 1, .8));
      RodConditions conditions;
      conditions.supports = {clamp(0), clamp(n)};
      conditions.supports[1].motion = {Vec3(1, 1, 0.3).normalized() * c.degrees * pi / 180, c.move};
      RodSolution s = solve_rod(tree, conditions);
      EXPECT_EQ(s.summary.status, Status::converged);
      return s;
    };
    expect_order([&](int n) { return std::abs(solve(n).summary.energy - c.energy); }, 2, 0.05);
    expect_order([&](int n) { return (solve(n).poses[index(n / 2)].position - c.middle).norm(); },
                 2, 0.05);
  }
}

// A slenderness of 1e6 between clamps works as well as 1e2: few iterations, round-off only.
TEST(Convergence, TwoClampsAtAnySlenderness) {
  for (int e = 1; e <= 6; ++e) {
    const double ea = 12 * std::pow(10., 2 * e);
    const RodTree tree = chain(along_x, 1, Vec3::Zero(), 64, isotropic(.4 * ea, ea, 1, .8));
    RodConditions conditions;
    conditions.supports = {clamp(0), clamp(64)};
    conditions.supports[1].motion = {Vec3(1, 1, 0.3).normalized() * pi / 3, {-.2, .1, .05}};
    const RodSolution s = solve_rod(tree, conditions);
    EXPECT_EQ(s.summary.status, Status::converged) << e;
    EXPECT_LE(s.summary.iterations, 13) << e;
    EXPECT_LT(s.summary.last_step, 1e-8) << e;
    EXPECT_LT(s.summary.residual, 1e-11) << e;
    EXPECT_LT((s.reactions[0].force + s.reactions[1].force).norm(),
              1e-11 * s.reactions[0].force.norm())
        << e;
  }
}

}  // namespace
}  // namespace vasorod
