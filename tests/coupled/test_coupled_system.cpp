#include <Eigen/Eigenvalues>
#include <algorithm>
#include <gtest/gtest.h>
#include <memory>
#include <random>

#include "coupled/coupled_system.h"
#include "coupled/held_tubes.h"
#include "coupled/wall_lumen.h"

namespace vasorod {
namespace {

using namespace testing;
using Eigen::VectorXd;

VectorXd noise(Eigen::Index n, double size, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-size, size);
  VectorXd v(n);
  for (Eigen::Index i = 0; i < n; ++i) v[i] = uniform(random);
  return v;
}

// A short tube. Its start has a rigid section with some free and loaded components, its end a soft
// one; a seam joins its middle and its rim; it touches a plane and itself.
struct Everything {
  HeldTube tube{4, 1.5, 0.4, 6, 3};
  std::unique_ptr<WallEnergy> energy;
  CoupledSystem system;
  VectorXd z;
  Everything(std::array<bool, 6> fixed_start, std::array<bool, 6> fixed_end,
             bool both_rigid = false) {
    HeldSection start = tube.start(), end = tube.end();
    start.fixed = fixed_start;
    start.frame = exp_rotation(Vec3(0.3, -0.2, 0.5));
    start.motion.rotate = Vec3(0.2, 0.5, -0.3);
    start.force = Vec3(0.01, -0.02, 0.03);
    start.moment = Vec3(0.02, 0.01, -0.01);
    end.rigid = both_rigid;
    end.fixed = fixed_end;
    end.motion.move = Vec3(0.1, 0.2, 0.1);
    end.body_moment = Vec3(0.03, 0.01, -0.02);
    WallInput wall = tube.wall;
    wall.glued.assign(static_cast<size_t>(tube.surface.points.rows()), 0);
    for (const HeldSection* s : {&start, &end})
      if (s->rigid)
        for (const int v : s->ring) wall.glued[static_cast<size_t>(v)] = 1;
    energy = std::make_unique<WallEnergy>(wall);
    system.add_wall(*energy, tube.surface.points, {start, end}, 3);
    system.set_lumen(0, wall_lumen(wall, {start, end}, {}, {0.01, 0.05}));
    system.finish();
    system.joins = {{0, 12, Vec3(0.1, 0.2, 0.3)}, {13, 20, Vec3(-0.1, 0.1, 0)}};
    system.k_j = 0.7;
    system.contacts = {{1, {12, 13, 14}, Vec3(0.2, 0.3, 0.5), Vec3(0.6, 0, 0.8), 1.5, 0.7, 2, 9},
                       {15, {-1, -1, -1}, Vec3::Zero(), Vec3(0, 1, 0), 9, 0.4, 2, 1}};
    system.set_time(0.8);
    system.put(0, tube.surface.points, false, z);
    system.put_pose(0, 0, exp_rotation(Vec3(0.4, 0.3, -0.2)), Vec3(0.1, -0.1, 0.2), z);
    system.put_pose(0, 1, exp_rotation(Vec3(-0.2, 0.3, 0.1)), Vec3(0.1, -0.1, 4.2), z);
    z += noise(z.size(), 0.05, 1);
    system.update_ties(z);
    z += noise(z.size(), 0.05, 2);
  }
};

void expect_derivatives(Everything& e) {
  VectorXd g, above, below;
  e.system.gradient(e.z, g);
  const Eigen::MatrixXd lower = e.system.hessian(e.z);
  const Eigen::MatrixXd hessian = lower.selfadjointView<Eigen::Lower>();
  const double step = 1e-5;
  double worst_gradient = 0, worst_hessian = 0;
  for (Eigen::Index i = 0; i < e.z.size(); ++i) {
    VectorXd z = e.z;
    z[i] += step;
    const double up = e.system.gradient(z, above).total();
    z[i] -= 2 * step;
    const double down = e.system.gradient(z, below).total();
    worst_gradient = std::max(worst_gradient, std::abs((up - down) / (2 * step) - g[i]));
    worst_hessian = std::max(worst_hessian,
                             ((above - below) / (2 * step) - hessian.col(i)).cwiseAbs().maxCoeff());
  }
  EXPECT_LT(worst_gradient, 1e-7 * g.cwiseAbs().maxCoeff());
  EXPECT_LT(worst_hessian, 1e-6 * hessian.cwiseAbs().maxCoeff());
}

TEST(CoupledSystem, DerivativesMatchDifferencesWithFreePoses) {
  Everything free_both({false, false, false, false, false, false},
                       {false, false, false, false, false, false});
  expect_derivatives(free_both);
}

TEST(CoupledSystem, DerivativesMatchDifferencesWithSomeFreedomsFixed) {
  Everything some({true, false, true, false, true, false},
                  {false, true, false, false, false, true});
  expect_derivatives(some);
}

TEST(CoupledSystem, DerivativesMatchDifferencesBetweenRigidSections) {
  Everything rigid({false, false, true, false, true, false}, {true, true, true, true, true, true},
                   true);
  expect_derivatives(rigid);
}

TEST(CoupledSystem, ConvexPartIsPositiveSemidefiniteWhereTheHessianIsNot) {
  const std::array<bool, 6> free{}, fixed{true, true, true, true, true, true};
  for (const std::array<bool, 6>& held : {free, fixed}) {
    Everything e(held, held, true);
    const auto least = [&](SecondDerivatives second) {
      const Eigen::MatrixXd lower = e.system.hessian(e.z, second);
      const Eigen::MatrixXd whole = lower.selfadjointView<Eigen::Lower>();
      return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(whole, Eigen::EigenvaluesOnly)
                 .eigenvalues()[0] /
             whole.norm();
    };
    EXPECT_GT(least(SecondDerivatives::convex), -1e-12);
    EXPECT_LT(least(SecondDerivatives::all), -1e-4);
  }
}

// Of the same state, where only some vertices move.
TEST(CoupledSystem, APatchHasTheDerivativesOfTheWholeAndHoldsTheRest) {
  const std::array<bool, 6> fixed{true, true, true, true, true, true};
  Everything all(fixed, fixed, true);
  const CoupledState at = all.system.state(all.z);
  const CoupledWall& wall = all.system.walls()[0];
  WallPatch patch{std::vector<char>(static_cast<size_t>(all.energy->vertices()), 0), at.q[0]};
  for (const size_t v : {12, 13, 14, 15}) patch.moves[v] = 1;
  std::vector<HeldSection> sections;
  for (const SectionPose& pose : wall.sections) sections.push_back(pose.section());
  CoupledSystem system;
  system.add_wall(*all.energy, wall.rest, sections, 3, &patch);
  WallLumen lumen = *wall.lumen;
  system.set_lumen(0, std::move(lumen));
  system.finish();
  system.joins = all.system.joins;
  system.k_j = all.system.k_j;
  system.contacts = all.system.contacts;
  system.set_time(0.8);
  const CoupledWall& small = system.walls()[0];
  ASSERT_GT(system.unknowns(), 12);
  ASSERT_LT(system.unknowns(), all.system.unknowns());
  VectorXd z(system.unknowns());
  std::vector<int> whole(static_cast<size_t>(system.unknowns()), -1);
  for (size_t i = 0; i < small.unknown.size(); ++i)
    if (small.unknown[i] >= 0) {
      z[small.unknown[i]] = at.q[0][static_cast<Eigen::Index>(i)];
      whole[static_cast<size_t>(small.unknown[i])] = wall.unknown[i];
    }
  EXPECT_LT((system.state(z).positions - at.positions).norm(), 1e-14);
  VectorXd g, whole_g;
  system.gradient(z, g);
  all.system.gradient(all.z, whole_g);
  EXPECT_LT((g - whole_g(whole)).norm(), 1e-13 * whole_g.norm());
  const Eigen::MatrixXd lower = system.hessian(z), whole_lower = all.system.hessian(all.z);
  const Eigen::MatrixXd h = lower.selfadjointView<Eigen::Lower>(),
                        whole_h = whole_lower.selfadjointView<Eigen::Lower>();
  EXPECT_LT((h - whole_h(whole, whole)).norm(), 1e-13 * whole_h.norm());
  const CoupledState moved = system.state(z + VectorXd::Ones(z.size()));
  for (int v = 0; v < all.energy->vertices(); ++v)
    EXPECT_NEAR((moved.positions.row(v) - at.positions.row(v)).norm(),
                patch.moves[static_cast<size_t>(v)] ? std::sqrt(3.0) : 0, 1e-12)
        << v;
}

TEST(CoupledSystem, DerivativesMatchDifferencesOfAGuardedWall) {
  Everything flat({false, false, false, false, false, false}, {true, true, true, true, true, true});
  VectorXd g;
  Points pressed = flat.tube.surface.points;
  pressed.col(1) *= 0.15;
  flat.system.put(0, pressed, true, flat.z);
  flat.z += noise(flat.z.size(), 0.02, 3);
  const double free = flat.system.gradient(flat.z, g).contact;
  flat.system.set_guard(0, std::make_shared<CrossingGuard>(flat.tube.surface, 0.4, 0.5));
  EXPECT_TRUE(flat.system.guarded());
  EXPECT_GT(flat.system.gradient(flat.z, g).contact, free);
  expect_derivatives(flat);
  CoupledForces f;
  flat.system.gradient(flat.z, g, &f);
  EXPECT_GT(f.guard.norm(), 0);
  EXPECT_LT(f.guard.colwise().sum().norm(), 1e-12 * f.guard.norm());
  // One vertex a sixth of an edge towards the opposite wall and back: it may go all the way back.
  const int moved = flat.system.walls()[0].unknown[3 * 8 + 1];
  ASSERT_GE(moved, 0);
  VectorXd step = VectorXd::Zero(flat.z.size());
  step[moved] = flat.z[moved] > 0 ? -0.25 : 0.25;
  const double there = flat.system.longest_share(flat.z, step);
  EXPECT_LT(there, 1);
  EXPECT_EQ(flat.system.longest_share(flat.z, -step), 1);
}

// The minimiser adds entries of the one at rest to the other.
TEST(CoupledSystem, TheHessianHasAnEntryWhereTheOneAtRestHas) {
  for (const auto& [scan, after] : {std::pair{0.01, 0.0}, {0.0, 0.01}, {0.0, 0.0}, {0.01, 0.02}}) {
    const HeldTube tube(4, 1.5, 0.4, 6, 3);
    WallEnergy energy(tube.wall);
    CoupledSystem system;
    system.add_wall(energy, tube.surface.points, {}, 3);
    system.set_lumen(0, wall_lumen(tube.wall, {}, {}, {scan, after}));
    system.finish();
    system.set_time(1);
    VectorXd z = VectorXd::Zero(system.unknowns());
    system.put(0, tube.surface.points, false, z);
    const Eigen::SparseMatrix<double> rest = system.rest_hessian(), now = system.hessian(z);
    int missing = 0;
    for (int column = 0; column < rest.cols(); ++column) {
      const int* const begin = now.innerIndexPtr() + now.outerIndexPtr()[column];
      const int* const end = now.innerIndexPtr() + now.outerIndexPtr()[column + 1];
      for (Eigen::SparseMatrix<double>::InnerIterator it(rest, column); it; ++it)
        missing += std::find(begin, end, it.row()) == end;
    }
    EXPECT_EQ(missing, 0) << scan << " as scanned, " << after << " after";
  }
}

TEST(CoupledSystem, TurnedRestHessianIsTheHessianOfTheTurnedWall) {
  HeldTube tube(4, 1.5, 0.4, 6, 3);
  WallEnergy energy(tube.wall);
  CoupledSystem system;
  system.add_wall(energy, tube.surface.points, {}, 1);
  system.finish();
  const Mat3 turn = exp_rotation(Vec3(0.7, -0.4, 1.1));
  VectorXd z;
  system.put(0, tube.surface.points * turn.transpose(), false, z);
  const Eigen::SparseMatrix<double> now = system.hessian(z);
  Eigen::SparseMatrix<double> rest = system.rest_hessian();
  turn_matrix(
      system.turns(std::vector<Mat3>(static_cast<size_t>(system.vertex_count()), turn), {{}}),
      rest);
  EXPECT_LT((now - rest).norm(), 1e-9 * now.norm());
}

}  // namespace
}  // namespace vasorod
