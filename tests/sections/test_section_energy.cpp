#include <gtest/gtest.h>
#include <numbers>

#include "some_tube.h"

namespace vasorod {
namespace {

using Eigen::MatrixXd;
using testing::disturbed, testing::straight_shape, testing::wall_of_shape;

using testing::moved;

const SectionSpace space{2, AxialBasis(5, 3)};

void expect_derivatives(const SectionEnergy& energy) {
  const MatrixXd at = disturbed(straight_shape(space, 1.05, 4.2), 0.06).coefficients;
  MatrixXd gradient, low, high;
  double size = 0;
  energy.gradient(at, gradient, size);
  EXPECT_GE(size, gradient.norm() / 4);
  BlockBand hessian = energy.empty_hessian();
  energy.hessian(at, hessian);
  const double h = 1e-5;
  double slope_error = 0, change_error = 0, largest = 0;
  for (Eigen::Index j = 0; j < at.cols(); ++j)
    for (Eigen::Index k = 0; k < at.rows(); ++k) {
      MatrixXd before = at, after = at;
      before(k, j) -= h;
      after(k, j) += h;
      const double slope =
          (energy.gradient(after, high, size) - energy.gradient(before, low, size)) / (2 * h);
      slope_error = std::max(slope_error, std::abs(slope - gradient(k, j)));
      for (Eigen::Index i = 0; i < at.cols(); ++i) {
        const Eigen::VectorXd found =
            hessian.block(static_cast<int>(i), static_cast<int>(j)).col(k);
        largest = std::max(largest, found.norm());
        change_error = std::max(
            change_error, (found - (high.col(i) - low.col(i)) / (2 * h)).cwiseAbs().maxCoeff());
      }
    }
  EXPECT_LT(slope_error, 1e-7 * gradient.norm());
  EXPECT_LT(change_error, 1e-7 * largest);
}

TEST(SectionEnergy, DerivativesMatchDifferences) {
  SectionEnergy energy(
      wall_of_shape(disturbed(straight_shape(space, 1, 4), 0.02), 0.1, Law::biot, 0.03));
  expect_derivatives(energy);
  energy.set_pressure(0.1);
  expect_derivatives(energy);
  energy.set_prestress(disturbed(straight_shape(space, 0.02, 0.1), 0.01).coefficients, 1.05);
  expect_derivatives(energy);
}

// What a pressure adds over itself.
double volume(SectionEnergy& energy, const MatrixXd& at, MatrixXd& gradient) {
  MatrixXd without;
  double size = 0;
  energy.set_pressure(0);
  const double of_wall = energy.gradient(at, without, size);
  energy.set_pressure(1);
  const double volume = of_wall - energy.gradient(at, gradient, size);
  gradient = without - gradient;
  return volume;
}

TEST(SectionEnergy, TheLumenOfATubeIsThatOfItsInnerFaceOnItsStrip) {
  const double radius = 2, length = 5, thickness = 0.1, offset = 0.02, nu = 0.3;
  SectionEnergy energy(
      wall_of_shape(straight_shape(space, radius, length), thickness, Law::biot, offset, nu));
  MatrixXd unused;
  const double depth = thickness / 2 - offset, side = 2 * std::numbers::pi * radius * length;
  EXPECT_NEAR(volume(energy, straight_shape(space, radius, length).coefficients, unused),
              std::numbers::pi * radius * radius * length - depth * side, 1e-12);
  // Twice as long and as wide: the tissue thins by A^m, m = (1 - 2 nu) / (1 - nu).
  EXPECT_NEAR(volume(energy, straight_shape(space, 2 * radius, 2 * length).coefficients, unused),
              8 * std::numbers::pi * radius * radius * length -
                  depth * side * std::pow(4, (1 - 2 * nu) / (1 - nu)),
              1e-11);
}

TEST(SectionEnergy, TheLumenDoesNotDependOnTheOrigin) {
  const SectionShape rest = disturbed(straight_shape(space, 1, 4), 0.02),
                     now = disturbed(straight_shape(space, 1.05, 4.2), 0.06);
  SectionEnergy energy(wall_of_shape(rest, 0.1));
  MatrixXd gradient, there;
  const Pose motion{exp_rotation(Vec3(0.7, -1.2, 0.4)), Vec3(30, 10, -20)};
  const double one = volume(energy, now.coefficients, gradient),
               other = volume(energy, moved(now, motion), there);
  EXPECT_NEAR(one, other, 1e-10 * one);
  // So that a closed lumen has no resultant: the first harmonics of all rows sum to nothing.
  for (int k = 0; k < 3; ++k)
    EXPECT_NEAR(gradient.row(k * space.modes()).sum(), 0, 1e-12 * gradient.norm());
}

TEST(SectionEnergy, ARigidMotionCostsNothing) {
  const SectionShape rest = disturbed(straight_shape(space, 1, 4), 0.02);
  const SectionEnergy energy(wall_of_shape(rest, 0.1));
  MatrixXd gradient;
  double size = 0;
  const Pose motion{exp_rotation(Vec3(0.7, -1.2, 0.4)), Vec3(3, 1, -2)};
  EXPECT_NEAR(energy.gradient(moved(rest, motion), gradient, size), 0, 1e-14);
  EXPECT_LT(gradient.norm(), 1e-13);
}

TEST(SectionEnergy, ATwistedTubeHasTheEnergyOfItsShear) {
  // Twist per length k: G J k^2 L / 2 with the annulus' polar moment.
  const double radius = 1, thickness = 0.1, length = 5, twist = 1e-3;
  const SectionSpace fine{1, AxialBasis(6, 3)};
  const SectionEnergy energy(wall_of_shape(straight_shape(fine, radius, length), thickness));
  SectionShape now = straight_shape(fine, radius, length);
  const Eigen::VectorXd points = fine.along.interpolation_points();
  for (int i = 0; i < fine.along.count(); ++i) {
    const double a = twist * length * points[i];  // small: the control points turn as the sections
    now.coefficients(2, i) = -radius * a;
    now.coefficients(fine.modes() + 1, i) = radius * a;
  }
  MatrixXd gradient;
  double size = 0;
  const double outer = radius + thickness / 2, inner = radius - thickness / 2;
  const double polar = std::numbers::pi / 2 * (std::pow(outer, 4) - std::pow(inner, 4));
  const double expected = polar / 2.6 * twist * twist * length / 2;
  EXPECT_NEAR(energy.gradient(now.coefficients, gradient, size) / expected, 1, 2e-3);
  const SectionEnergy::Report report = energy.report(now.coefficients);
  EXPECT_NEAR((report.membrane + report.bending) / expected, 1, 2e-3);
  EXPECT_GT(report.faces.largest, 1 + twist / 2 * 0.9);
}

TEST(SectionEnergy, HasTheHessianOfEveryLaw) {
  for (const Law law : {Law::svk, Law::neo_hookean}) {
    const SectionEnergy energy(wall_of_shape(straight_shape(space, 1, 4), 0.2, law));
    const MatrixXd at = disturbed(straight_shape(space, 1.05, 4.2), 0.06).coefficients,
                   way = disturbed(straight_shape(space, 0.3, 1), 0.3).coefficients;
    BlockBand hessian = energy.empty_hessian();
    energy.hessian(at, hessian);
    MatrixXd low, high, product = MatrixXd::Zero(at.rows(), at.cols());
    double size = 0;
    const double h = 1e-5;
    energy.gradient(at - h * way, low, size);
    energy.gradient(at + h * way, high, size);
    for (int i = 0; i < at.cols(); ++i)
      for (int j = 0; j < at.cols(); ++j) product.col(i) += hessian.block(i, j) * way.col(j);
    EXPECT_LT((product - (high - low) / (2 * h)).norm(), 1e-6 * product.norm());
  }
}

}  // namespace
}  // namespace vasorod
