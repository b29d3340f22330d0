#include <gtest/gtest.h>

#include "sections/section_prestress.h"
#include "some_tube.h"

namespace vasorod {
namespace {

using Eigen::MatrixXd, Eigen::VectorXd;
using testing::disturbed, testing::moved, testing::straight_shape, testing::wall_of_shape;

const SectionSpace space{2, AxialBasis(7, 3)};
constexpr double length = 5;

HeldEnds ends_of(bool rigid) {
  HeldEnds ends;
  for (const bool last : {false, true}) {
    HeldSection& end = ends[last ? 1 : 0].emplace();
    end.rigid = rigid;
    end.rest.position = {0, 0, last ? length : 0.0};
  }
  return ends;
}

double largest_entry(const MatrixXd& displacement) {
  return displacement.cwiseAbs().maxCoeff();
}

SeenSections linear_displacement(const SectionWall& wall, const HeldEnds& ends, double pressure,
                                 double stretch) {
  return seen_sections(wall, ends, pressure, stretch, "", 1);
}

// The unknowns of the wall as it was seen, or of that shape less a displacement.
VectorXd as_seen(const SectionWall& wall, const HeldEnds& ends, SectionSystem& system,
                 const MatrixXd& less = MatrixXd::Zero(space.row_size(), space.along.count())) {
  std::array<Pose, 2> poses;
  for (size_t e = 0; e < 2; ++e) poses[e].position = ends[e]->rest.position;
  return system.unknowns_of(wall.rest.coefficients - less, poses);
}

class SectionPrestressOf : public ::testing::TestWithParam<Law> {};
INSTANTIATE_TEST_SUITE_P(Laws, SectionPrestressOf,
                         ::testing::Values(Law::biot, Law::svk, Law::neo_hookean));

// Whatever its shape, the wall as it was seen is in equilibrium, and its energy's slope is exact.
TEST_P(SectionPrestressOf, TheSeenShapeIsInEquilibrium) {
  const SectionShape rest = disturbed(straight_shape(space, 1, length), 0.03);
  const SectionWall wall = wall_of_shape(rest, 0.1, GetParam(), 0.02);
  for (const bool rigid : {true, false}) {
    const HeldEnds ends = ends_of(rigid);
    const double pressure = 0.004, stretch = 1.06;
    const SeenSections seen = linear_displacement(wall, ends, pressure, stretch);
    EXPECT_GT(seen.displacement.cwiseAbs().maxCoeff(), 0.02);
    SectionSystem system(wall, ends);
    system.set_lumen({pressure, 0});
    give_prestress(seen, stretch, system);
    system.set_time(0);
    const VectorXd z = as_seen(wall, ends, system);
    const SectionSystem::Gradient at = system.gradient(z);
    EXPECT_LT(at.gradient.norm(), 1e-12 * at.size) << rigid;
    // Without the pressure it is not.
    system.set_time(1);
    const SectionSystem::Gradient without = system.gradient(z);
    EXPECT_GT(without.gradient.norm(), 1e-3 * without.size);
  }
}

// Widened by a third, from the shape without stress; of which without the pressure no stress is
// left.
TEST_P(SectionPrestressOf, TheSeenShapeIsInEquilibriumFromAFarOne) {
  const SectionShape rest = disturbed(straight_shape(space, 1, length), 0.03);
  const SectionWall wall = wall_of_shape(rest, 0.1, GetParam(), 0.02);
  for (const bool rigid : {true, false}) {
    const HeldEnds ends = ends_of(rigid);
    const double pressure = 0.03, stretch = 1.1;
    SeenSections seen = seen_sections(wall, ends, pressure, stretch, "", 0.1);
    EXPECT_GT(seen.steps, 0) << rigid;
    EXPECT_GT(largest_entry(seen.displacement), 0.2) << rigid;
    SectionSystem system(wall, ends);
    system.set_lumen({pressure, pressure});
    give_prestress(seen, stretch, system);
    system.set_time(0);
    const VectorXd z = as_seen(wall, ends, system);
    const SectionSystem::Gradient at = system.gradient(z);
    EXPECT_LT(at.gradient.norm(), 1e-10 * at.size) << rigid;

    seen = seen_sections(wall, ends, pressure, 1, "", 0.1);
    give_prestress(seen, 1, system);
    system.set_lumen({0, 0});
    system.set_time(0);
    const SectionSystem::Gradient free =
        system.gradient(as_seen(wall, ends, system, seen.displacement));
    EXPECT_NEAR(free.value, 0, 1e-24) << rigid;
  }
}

// Where the shape without stress lies does not count: its fibres turn with it.
TEST(SectionPrestress, ATurnedShapeWithoutStressIsTheSame) {
  const SectionShape rest = disturbed(straight_shape(space, 1, length), 0.03);
  SectionWall wall = wall_of_shape(rest, 0.1, Law::biot, 0.02);
  wall.material.shear_axial *= 0.3;
  const MatrixXd turned = moved(rest, {exp_rotation(Vec3(0.5, -0.3, 0.9)), Vec3(2, 1, -3)});
  SectionEnergy energy(wall);
  const SectionShape now = disturbed(rest, 0.05);
  MatrixXd one, other;
  double size = 0;
  energy.set_stress_free_shape(MatrixXd::Zero(turned.rows(), turned.cols()), 1.2);
  const double value = energy.gradient(now.coefficients, one, size);
  energy.set_stress_free_shape(rest.coefficients - turned, 1.2);
  EXPECT_NEAR(energy.gradient(now.coefficients, other, size), value, 1e-12 * value);
  EXPECT_LT((one - other).norm(), 1e-11 * one.norm());
}

// Between soft ends held apart a straight tube of nu 0 widens by p r_i R^2 / (E t R) in all its
// length: its hoop strain is p r_i / (E t), and its own prestress is that tension.
TEST(SectionPrestress, OfATubeIsItsHoopTension) {
  const double thickness = 0.02, pressure = 1e-5;
  const SectionWall wall =
      wall_of_shape(straight_shape(space, 1, length), thickness, Law::biot, 0, 0);
  const MatrixXd seen = linear_displacement(wall, ends_of(false), pressure, 1).displacement;
  const double strain = pressure * (1 - thickness / 2) / thickness;
  EXPECT_NEAR(seen(1, 5) / strain, 1, 2e-3);
  EXPECT_NEAR(seen(space.modes() + 2, 5) / strain, 1, 2e-3);
  SectionEnergy energy(wall);
  energy.set_prestress(seen, 1);
  EXPECT_NEAR(energy.rms_prestrain() / strain, 1, 2e-3);
  MatrixXd gradient;
  double size = 0;
  const double stored = energy.gradient(wall.rest.coefficients, gradient, size);
  const double tension = pressure * (1 - thickness / 2);
  EXPECT_NEAR(stored / (2 * M_PI * length * tension * strain / 2), 1, 5e-3);
  const SectionEnergy::Report report = energy.report(wall.rest.coefficients);
  EXPECT_NEAR(report.membrane + report.bending, stored, 1e-14 * stored);
  EXPECT_NEAR(report.faces.largest, 1, 1e-12);
}

}  // namespace
}  // namespace vasorod
