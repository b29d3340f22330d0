#include <gtest/gtest.h>
#include <numbers>

#include "geometry/rigid_motion.h"
#include "rod/energy.h"
#include "rod/lumen_section.h"
#include "rod/rods.h"

namespace vasorod {
namespace {

constexpr double pi = std::numbers::pi;

// Lame's displacement of a held tube, p a^2 (1 + nu) ((1 - 2 nu) r + b^2 / r) / (E (b^2 - a^2)), as
// docs/wall.md has it for R 10, t 1: .881404 and .746255 at p = .01 E, mid-wall.
TEST(LumenSection, WidensAsLamesTube) {
  const AnnularSection section{10, 1};
  for (const auto& [nu, expected] : {std::pair(0.3, 0.881404), {0.5, 0.746255}}) {
    const LumenSection now = lumen_section(section, Material::isotropic(2, nu), 0, 0.02);
    EXPECT_NEAR(10 * now.mid_strain, expected, 1e-6);
  }
}

// An incompressible wall keeps its area: r times the strain at r does not depend on r.
TEST(LumenSection, AnIncompressibleWallKeepsItsArea) {
  const LumenSection now = lumen_section({10, 3}, Material::isotropic(2, 0.5), 0, 0.02);
  EXPECT_NEAR(8.5 * 8.5 * now.inner_strain, 100 * now.mid_strain, 1e-12);
}

// Betti: the volume that a pressure adds per stretch equals the force it puts on the held length.
// With e = 0, as at the scan, the force on a wall with a fibre is that of Lame's stresses, whose
// sum over the wall is nu_LT 2 p pi a^2.
TEST(LumenSection, ThrustIsThePressureLessPoissonsForce) {
  Material fibre = Material::isotropic(2, 0.3);
  fibre.young_axial = 5;
  fibre.poisson_lt = 0.4;
  const LumenSection now = lumen_section({10, 1}, fibre, 0.03, 0.03);
  EXPECT_EQ(now.inner_strain, 0);
  const double disk = pi * 9.5 * 9.5;
  EXPECT_NEAR(now.area, disk, 1e-12 * disk);
  EXPECT_NEAR(now.thrust, 0.03 * disk * (1 - 0.8), 1e-12);
}

// The hoop strain of a wall with a fibre, from the compliance of the solid: axial strain zero.
TEST(LumenSection, AFibreHoldsTheWallBack) {
  Material fibre = Material::isotropic(2, 0.3);
  fibre.young_axial = 5;
  fibre.poisson_lt = 0.4;
  const double a = 9.5, b = 10.5, r = 10, p = 0.01, base = p * a * a / (b * b - a * a);
  const double radial = base * (1 - b * b / (r * r)), hoop = base * (1 + b * b / (r * r)),
               axial = 0.4 * (radial + hoop);  // E_L e_z = axial - nu_LT (radial + hoop) = 0
  const double expected = hoop / 2 - 0.3 * radial / 2 - 0.4 * axial / 5;
  EXPECT_NEAR(p * hoop_strain_per_pressure({10, 1}, fibre, r), expected, 1e-15);
}

// Derivative of p V along v3, V = pi (a (1 + e))^2 v3 with Poisson's de/dv3 = -nu, by differences.
TEST(LumenSection, ThrustIsTheVolumesDerivative) {
  const double nu = 0.3, p = 0.02, h = 1e-6;
  const LumenSection now = lumen_section({10, 1}, Material::isotropic(2, nu), 0.005, p);
  const auto volume = [&](double change) {
    const double radius = 9.5 * (1 + now.inner_strain - nu * change);
    return pi * radius * radius * (1 + change);
  };
  EXPECT_NEAR(now.thrust, p * (volume(h) - volume(-h)) / (2 * h), 1e-8);
}

// The unit thrust of a branch's first element puts a force along its second node's axis and no
// moment on that node.
TEST(LumenSection, ABranchIsPushedAlongItsAxis) {
  RodElement element;
  element.length = 2;
  element.rest_strain = vec6(0.3, 0.1, 0.9, 0.2, -0.4, 0.1);
  element.natural_strain = element.rest_strain;
  element.stiffness = isotropic(1, 2, 3, 4).asDiagonal();
  element.lumen = 5 * unit_thrust(element, true);
  const Pose second = exp_motion(element.length * element.rest_strain);
  const Vec12 gradient = element_energy_gradient(element, Pose{}, second);
  EXPECT_LT((gradient.tail<6>() - vec6(0, 0, -5, 0, 0, 0)).norm(), 1e-14);
  EXPECT_EQ(unit_thrust(element, false), vec6(0, 0, 1, 0, 0, 0));
}

}  // namespace
}  // namespace vasorod
