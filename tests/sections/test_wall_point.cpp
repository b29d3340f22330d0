#include <gtest/gtest.h>
#include <numbers>

#include "sections/wall_point.h"
#include "some_tube.h"

namespace vasorod {
namespace {

using testing::disturbed, testing::moved, testing::straight_shape;

const SectionSpace space{3, AxialBasis(5, 3)};
constexpr double u = 0.37, angle = 1.1;

WallPoint some_point(Law law, double poisson = 0.3) {
  const SectionShape rest = disturbed(straight_shape(space, 1, 4), 0.02);
  return {rest.jet(u, angle),
          Vec3(0.1, 0.2, 1),
          -0.08,
          0.12,
          0.3,
          Material::isotropic(2, poisson, law)};
}

// The energy's gradient and Hessian against central differences.
void expect_derivatives(const WallPoint& point, const SurfaceJet& jet) {
  const PointEnergy at = point.energy(jet, true);
  const double h = 1e-5;
  Eigen::Matrix<double, 15, 1> slope;
  Eigen::Matrix<double, 15, 15> change;
  for (int k = 0; k < 15; ++k) {
    SurfaceJet before = jet, after = jet;
    before(k % 3, k / 3) -= h;
    after(k % 3, k / 3) += h;
    const PointEnergy low = point.energy(before, false), high = point.energy(after, false);
    slope[k] = (high.membrane + high.bending - low.membrane - low.bending) / (2 * h);
    change.col(k) = (high.gradient - low.gradient).reshaped() / (2 * h);
  }
  EXPECT_LT((slope - at.gradient.reshaped()).norm(), 1e-7 * (1e-3 + at.gradient.norm()));
  EXPECT_LT((change - at.hessian).norm(), 1e-6 * at.hessian.norm());
}

class WallPointOfALaw : public ::testing::TestWithParam<Law> {};
INSTANTIATE_TEST_SUITE_P(All, WallPointOfALaw,
                         ::testing::Values(Law::biot, Law::svk, Law::neo_hookean));

TEST_P(WallPointOfALaw, DerivativesMatchDifferences) {
  const SectionShape now = disturbed(straight_shape(space, 1.1, 4.2), 0.07);
  expect_derivatives(some_point(GetParam()), now.jet(u, angle));
}

TEST_P(WallPointOfALaw, ARigidMotionCostsNothing) {
  const SectionShape rest = disturbed(straight_shape(space, 1, 4), 0.02);
  const Pose motion{exp_rotation(Vec3(0.7, -1.2, 0.4)), Vec3(3, 1, -2)};
  const SectionShape there{space, moved(rest, motion)};
  const PointEnergy e = some_point(GetParam()).energy(there.jet(u, angle), false);
  EXPECT_NEAR(e.membrane + e.bending, 0, 1e-15);
  EXPECT_LT(e.gradient.norm(), 1e-14);
}

// Without stress shorter along its fibre and wider across: exact derivatives, and no stress there.
TEST_P(WallPointOfALaw, IsStretchedAsSeen) {
  const SectionShape rest = straight_shape(space, 1, 4), now = straight_shape(space, 0.95, 4.8);
  const Vec3 along(0, 0, 1);
  const Vec2 stretch(1.2, 0.95);
  const Material material = Material::isotropic(2, 0.3, GetParam());
  const WallPoint point(now.jet(u, angle), along, -8e-4, 1.2e-3, 0.3, material, stretch);
  expect_derivatives(point, disturbed(rest, 0.07).jet(u, angle));
  const WallPoint whole(rest.jet(u, angle), along, -8e-4, 1.2e-3, 0.3, material);
  EXPECT_NEAR(point.area(), whole.area(), 1e-12 * whole.area());
  // Its membrane is that of the shape from which the stretch leads to this one, if it is thin.
  const double expected = whole.energy(now.jet(u, angle), false).membrane;
  EXPECT_NEAR(point.energy(now.jet(u, angle), false).membrane, expected, 1e-4 * expected);
}

// With the stress of a displacement: exact derivatives, and at rest the slope of the energy is the
// Hessian there times that displacement.
TEST_P(WallPointOfALaw, CarriesAPrestress) {
  const SectionShape rest = disturbed(straight_shape(space, 1, 4), 0.02),
                     now = disturbed(straight_shape(space, 1.1, 4.2), 0.07);
  const SurfaceJet start = rest.jet(u, angle),
                   displacement = disturbed(straight_shape(space, 0.02, 0.1), 0.01).jet(u, angle);
  WallPoint point = some_point(GetParam());
  const Eigen::Matrix<double, 15, 1> expected =
      point.energy(start, true).hessian * displacement.reshaped();
  point.set_prestress(start, displacement, Vec3::Zero());
  const PointEnergy at = point.energy(start, false);
  EXPECT_LT((at.gradient.reshaped() - expected).norm(), 1e-13 * expected.norm());
  EXPECT_NEAR(at.membrane + at.bending, displacement.reshaped().dot(expected) / 2,
              1e-13 * expected.norm());
  point.set_prestress(start, displacement, Vec3(0.03, -0.01, 0));
  expect_derivatives(point, now.jet(u, angle));
  const Pose motion{exp_rotation(Vec3(0.7, -1.2, 0.4)), Vec3(3, 1, -2)};
  const SectionShape there{space, moved(now, motion)};
  const PointEnergy a = point.energy(now.jet(u, angle), false),
                    b = point.energy(there.jet(u, angle), false);
  EXPECT_NEAR(a.membrane, b.membrane, 1e-13);
  EXPECT_NEAR(a.bending, b.bending, 1e-13);
}

TEST(WallPoint, APulledTubeHasTheEnergyOfItsStretch) {
  // Stretched along by e with its radius held: e^2 / 2 E / (1 - nu^2) t (1 + z/R) over the wall.
  const double thickness = 0.2, stretch = 0.01, poisson = 0.3, radius = 1, length = 4;
  const SectionShape rest = straight_shape(space, radius, length),
                     now = straight_shape(space, radius, length * (1 + stretch));
  const WallPoint point(rest.jet(u, angle), Vec3::UnitZ(), -thickness / 2, thickness / 2, 1,
                        Material::isotropic(1, poisson));
  EXPECT_NEAR(point.area(), radius * length, 1e-12);
  const PointEnergy e = point.energy(now.jet(u, angle), false);
  EXPECT_NEAR(e.membrane + e.bending,
              radius * length * thickness * stretch * stretch / 2 / (1 - poisson * poisson), 1e-12);
  const FaceStretches faces = point.faces(now.jet(u, angle));
  EXPECT_NEAR(faces.largest, 1 + stretch, 1e-12);
  EXPECT_NEAR(faces.least, 1, 1e-12);
}

TEST(WallPoint, AnOvalisedRingBendsAsAThickRingDoes) {
  // Inextensible mode n = 2: Winkler's curved bar in plane strain, with the shear of a thick ring.
  const double thickness = 0.1, radius = 1, poisson = 0, a = 1e-4;
  SectionSpace one{4, AxialBasis(1, 3)};
  const SectionShape rest = straight_shape(one, radius, 1);
  SectionShape now = rest;
  // w = a cos 2t outward, v = -a/2 sin 2t around:
  // x = a (3 cos t + cos 3t) / 4, y = a (sin 3t - 3 sin t) / 4
  const int modes = one.modes();
  for (int i = 0; i < one.along.count(); ++i) {
    now.coefficients(1, i) += 3 * a / 4;
    now.coefficients(5, i) += a / 4;
    now.coefficients(modes + 2, i) -= 3 * a / 4;
    now.coefficients(modes + 6, i) += a / 4;
  }
  double energy = 0;
  const int points = 64;
  for (int q = 0; q < points; ++q) {
    const double t = 2 * std::numbers::pi * q / points;
    const WallPoint point(rest.jet(0.5, t), Vec3::UnitZ(), -thickness / 2, thickness / 2,
                          2 * std::numbers::pi / points, Material::isotropic(1, poisson));
    const PointEnergy e = point.energy(now.jet(0.5, t), false);
    energy += e.membrane + e.bending;
  }
  // EI/2 int (w'' + w)^2 / R^3 = 9/2 pi a^2 EI of a thin bar, softer by the shear across the wall,
  // 1 / (1 + 4 EI / (5/6 G A R^2)); a thick bar's moment is that of a thin one to (t/R)^2 / 10.
  const double inertia = std::pow(thickness, 3) / 12, shear = 5.0 / 6 * 0.5 * thickness;
  const double thin = 4.5 * inertia * a * a * std::numbers::pi;
  EXPECT_NEAR(energy / thin * (1 + 4 * inertia / shear), 1, 3e-3);
}

}  // namespace
}  // namespace vasorod
