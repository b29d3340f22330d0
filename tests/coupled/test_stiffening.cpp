#include <gtest/gtest.h>
#include <numbers>

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

// A tube that cannot be sheared answers a twist with wrinkles, which cost a small part of the
// energy of its torsion, G J phi^2 / (2 L); and it is not sheared.
TEST(Stiffening, ATwistedTubeThatCannotBeShearedWrinkles) {
  HeldTube tube(30, 6, 0.6, 16, 12);
  tube.wall.material.shear_axial *= 1e6;
  Vec6 twist = Vec6::Zero();
  twist[5] = 0.0005;
  CoupledSolver solver(bent(tube, twist, tube.start(), tube.end()));
  const CoupledSolution solution = solver.solve();
  EXPECT_EQ(solution.status, Status::converged) << to_string(solution.status);
  EXPECT_TRUE(solution.smallest_curvature_positive);
  EXPECT_LT(solution.surface.bodies[0].residual, 5e-7);
  EXPECT_TRUE(solution.notes.empty());
  const double torsion = 0.5 * tube.wall.material.shear_axial * 2 * std::numbers::pi * 216 * 0.6 *
                         30 * twist[5] * twist[5];
  const double energy = solution.membrane_energy + solution.bending_energy;
  EXPECT_GT(energy, 0);
  EXPECT_LT(energy, 1e-3 * torsion);
  // Solved again, and with an ordinary wall in between.
  const Material own = tube.wall.material;
  solver.set_material(0, Material::isotropic(1, 0.3));
  const CoupledSolution ordinary = solver.solve();
  tube.wall.material = Material::isotropic(1, 0.3);
  const CoupledSolution fresh = CoupledSolver(bent(tube, twist, tube.start(), tube.end())).solve();
  EXPECT_NEAR(ordinary.sections[0][1].moment.z(), fresh.sections[0][1].moment.z(),
              1e-7 * fresh.sections[0][1].moment.norm());
  solver.set_material(0, own);
  const CoupledSolution again = solver.solve();
  EXPECT_EQ(again.status, Status::converged);
  EXPECT_NEAR(again.membrane_energy + again.bending_energy, energy, 1e-4 * energy);
}

// A state on the way is not the scene's, and says so.
TEST(Stiffening, StoppedOnTheWayItSaysThatTheWallsAreSofter) {
  HeldTube tube(30, 6, 0.6, 16, 12);
  tube.wall.material.shear_axial *= 1e6;
  Vec6 twist = Vec6::Zero();
  twist[5] = 0.002;
  CoupledOptions options;
  options.stop = [] { return true; };
  const CoupledSolution solution =
      CoupledSolver(bent(tube, twist, tube.start(), tube.end()), options).solve();
  EXPECT_EQ(solution.status, Status::interrupted);
  ASSERT_FALSE(solution.notes.empty());
  EXPECT_EQ(solution.notes.back(), "the walls' shear modulus is still lower than the scene's");
}

}  // namespace
}  // namespace vasorod
