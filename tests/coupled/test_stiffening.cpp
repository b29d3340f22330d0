#include <algorithm>
#include <gtest/gtest.h>
#include <numbers>
#include <stdexcept>

#include "coupled/held_tubes.h"
#include "coupled/stiffening.h"

namespace vasorod {
namespace {

using namespace testing;

Material with_shear(double ratio) {
  Material material = Material::isotropic(2, 0.3);
  material.shear_axial *= ratio;
  return material;
}

TEST(Stiffening, OnlyAShearModulusFarAboveYoungsIsLowered) {
  for (const double ratio : {1e-9, 1e-3, 1.0, 1e3})
    EXPECT_EQ(eased(with_shear(ratio)).shear_axial, with_shear(ratio).shear_axial) << ratio;
  for (const double ratio : {1e4, 1e6, 1e12}) {
    const Material softer = eased(with_shear(ratio));
    EXPECT_NEAR(shear_ratio(softer), 2000, 1e-9 * 2000);
    EXPECT_EQ(softer.young_axial, 2);
    EXPECT_EQ(softer.young_transverse, 2);
  }
  Material soft_across = with_shear(10);  // that Young's modulus is not the larger one
  soft_across.young_transverse = 1e-4;
  EXPECT_EQ(eased(soft_across).shear_axial, soft_across.shear_axial);
}

TEST(Stiffening, WhatRoundingHidesIsKnown) {
  for (const double ratio : {1e-9, 1.0, 1e9}) EXPECT_FALSE(hides_forces(with_shear(ratio)));
  for (const double ratio : {1e-12, 1e12}) EXPECT_TRUE(hides_forces(with_shear(ratio)));
}

TEST(Stiffening, StepsEndAtTheOwnShearModulus) {
  const Material own = with_shear(1e9);
  Material now = eased(own);
  int steps = 0;
  while (now.shear_axial < own.shear_axial) {
    const double before = now.shear_axial;
    now = stiffened(now, own);
    EXPECT_GT(now.shear_axial, before);
    ++steps;
  }
  EXPECT_EQ(now.shear_axial, own.shear_axial);
  EXPECT_EQ(steps, 4);  // of ln(1e9 / 2000) / ln 30 = 3.9
}

HeldTube tube_of(const Material& material) {
  HeldTube tube(30, 6, 0.6, 16, 12);
  tube.wall.material = material;
  return tube;
}

Material ordinary() {
  return Material::isotropic(1, 0.3);
}

Material stiff_in_shear(double ratio = 1e6) {
  Material material = ordinary();
  material.shear_axial *= ratio;
  return material;
}

CoupledProblem twisted(const HeldTube& tube) {
  Vec6 twist = Vec6::Zero();
  twist[5] = 0.0005;
  return bent(tube, twist, tube.start(), tube.end());
}

double energy_of(const CoupledSolution& solution) {
  return solution.membrane_energy + solution.bending_energy;
}

void expect_minimum(const CoupledSolution& solution) {
  EXPECT_EQ(solution.status, Status::converged) << to_string(solution.status);
  EXPECT_TRUE(solution.smallest_curvature_positive);
  EXPECT_LT(solution.surface.bodies[0].residual, 5e-7);
  EXPECT_TRUE(solution.notes.empty()) << solution.notes[0];
}

// A tube that cannot be sheared answers a twist with wrinkles, which cost a small part of the
// energy of its torsion, G J phi^2 / (2 L), J = 2 pi R^3 t.
TEST(Stiffening, ATwistedTubeThatCannotBeShearedWrinkles) {
  const CoupledSolution solution = CoupledSolver(twisted(tube_of(stiff_in_shear()))).solve();
  expect_minimum(solution);
  const double torsion =
      0.5 * stiff_in_shear().shear_axial * 2 * std::numbers::pi * 216 * 0.6 * 30 * 0.0005 * 0.0005;
  EXPECT_GT(energy_of(solution), 0);
  EXPECT_LT(energy_of(solution), 1e-3 * torsion);
}

TEST(Stiffening, ASolverIsAsGoodAsNewAfterIt) {
  CoupledSolver solver(twisted(tube_of(stiff_in_shear())));
  const double energy = energy_of(solver.solve());
  solver.set_material(0, ordinary());
  const CoupledSolution soft = solver.solve();
  const CoupledSolution fresh = CoupledSolver(twisted(tube_of(ordinary()))).solve();
  EXPECT_NEAR(soft.sections[0][1].moment.z(), fresh.sections[0][1].moment.z(),
              1e-7 * fresh.sections[0][1].moment.norm());
  solver.set_material(0, stiff_in_shear());
  const CoupledSolution again = solver.solve();
  expect_minimum(again);
  EXPECT_NEAR(energy_of(again), energy, 1e-4 * energy);
}

// A state on the way is not the scene's, and says so; the solver goes on from the scene's walls.
TEST(Stiffening, StoppedOnTheWayItSaysThatTheWallsAreSofter) {
  CoupledSolver solver(twisted(tube_of(stiff_in_shear())));
  int calls = 0;
  solver.options().stop = [&] { return ++calls < 0; };
  const double energy = energy_of(solver.solve());
  bool at_once = false, while_stiffened = false;
  for (int last = calls / 2; !at_once; last = last * 4 / 5) {
    calls = 0;
    solver.options().stop = [&] { return ++calls > last; };
    const CoupledSolution stopped = solver.solve();
    EXPECT_EQ(stopped.status, Status::interrupted);
    const bool softer =
        !stopped.notes.empty() &&
        stopped.notes.back() == "the walls' shear modulus is still lower than the scene's";
    EXPECT_TRUE(softer || stopped.reached == 1) << last;  // else in the last step
    at_once = last == 0;
    while_stiffened |= softer && stopped.reached == 1;
  }
  EXPECT_TRUE(while_stiffened);
  solver.options().stop = [] { return false; };
  const CoupledSolution whole = solver.solve();
  expect_minimum(whole);
  EXPECT_NEAR(energy_of(whole), energy, 1e-4 * energy);
}

TEST(Stiffening, AnExceptionLeavesTheScenesWalls) {
  CoupledSolver solver(twisted(tube_of(stiff_in_shear())));
  const double energy = energy_of(solver.solve());
  int left = 20;
  solver.options().stop = [&]() -> bool {
    if (--left == 0) throw std::runtime_error("stop");
    return false;
  };
  EXPECT_THROW(solver.solve(), std::runtime_error);
  const CoupledSolution again = solver.solve();
  expect_minimum(again);
  EXPECT_NEAR(energy_of(again), energy, 1e-4 * energy);
}

// The forces of a rigid motion are all rounding.
TEST(Stiffening, ARigidMotionOfSuchAWallIsAMinimum) {
  for (const bool certify : {true, false}) {
    const HeldTube tube = tube_of(stiff_in_shear());
    CoupledProblem problem = bent(tube, Vec6::Zero(), tube.start(), tube.end());
    for (HeldSection& section : problem.vessels[0]->sections) section.motion.move = Vec3(1, 2, 3);
    problem.carried = [tube](double time) {
      CarriedBody body = carried_by(tube, Vec6::Unit(2), {0, tube.tube.length});
      body.points.rowwise() += time * Vec3(1, 2, 3).transpose();
      for (Pose& pose : body.sections) pose.position += time * Vec3(1, 2, 3);
      return std::vector<CarriedBody>{body};
    };
    CoupledOptions options;
    options.certify = certify;
    const CoupledSolution solution = CoupledSolver(std::move(problem), options).solve();
    EXPECT_EQ(solution.status, Status::converged) << to_string(solution.status);
    EXPECT_LT(energy_of(solution), 1e-12);
  }
}

// A vessel that nothing moves beside one that is moved.
TEST(Stiffening, AVesselAtRestIsNotEased) {
  CoupledProblem problem = twisted(tube_of(ordinary()));
  const CoupledSolution alone = CoupledSolver(twisted(tube_of(ordinary()))).solve();
  HeldTube far = tube_of(stiff_in_shear());
  far.surface.points.col(0).array() += 30;
  far.wall.rest = far.surface;
  HeldSection start = far.start(), end = far.end();
  start.rest.position.x() += 30;
  end.rest.position.x() += 30;
  CoupledProblem other = bent(far, Vec6::Zero(), start, end);
  problem.surfaces.bodies.push_back(other.surfaces.bodies[0]);
  problem.vessels.push_back(std::move(other.vessels[0]));
  problem.carried = [first = problem.carried](double time) {
    return std::vector<CarriedBody>{first(time)[0], CarriedBody()};
  };
  const CoupledSolution solution = CoupledSolver(std::move(problem)).solve();
  expect_minimum(solution);
  EXPECT_EQ(solution.surface.work.counts.hessians, alone.surface.work.counts.hessians);
}

// E and G 1e12 apart: what rounding leaves of the forces is stated.
TEST(Stiffening, WhereRoundingHidesForcesTheResultSaysSo) {
  const CoupledSolution solution = CoupledSolver(twisted(tube_of(stiff_in_shear(1e12)))).solve();
  EXPECT_EQ(solution.status, Status::iteration_limit) << to_string(solution.status);
  const auto says = [&](const std::string& text) {
    return std::any_of(solution.notes.begin(), solution.notes.end(), [&](const std::string& note) {
      return note.find(text) != std::string::npos;
    });
  };
  EXPECT_TRUE(says("vessel tube: its shear modulus lies more than 1e10 times"));
}

}  // namespace
}  // namespace vasorod
