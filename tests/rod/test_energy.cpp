#include <cmath>
#include <gtest/gtest.h>

#include "geometry/rigid_motion.h"
#include "rod/energy.h"

namespace vasorod {
namespace {

Vec6 vec6(double a, double b, double c, double d, double e, double f) {
  Vec6 x;
  x << a, b, c, d, e, f;
  return x;
}

// An element far from rest, with a full stiffness.
struct Fixture {
  RodElement element;
  Pose first = exp_motion(vec6(1, 2, 3, 0.3, -0.8, 0.5));
  Pose second;
  explicit Fixture(double angle) {
    element.length = 0.7;
    element.start = exp_motion(vec6(0.2, 0.1, -0.3, 0.5, 0.4, -0.6));
    element.natural_strain = vec6(0.02, -0.05, 1.1, 0.4, -0.3, 0.2);
    Mat6 m;
    for (int i = 0; i < 6; ++i)
      for (int j = 0; j < 6; ++j) m(i, j) = 0.1 * ((i * 7 + j * 3) % 5);
    element.stiffness = m * m.transpose() + Mat6(vec6(5, 6, 9, 1, 2, 1.5).asDiagonal());
    Vec6 xi = vec6(0.1, -0.2, 0.8, 0.6, -0.7, 0.4);
    xi.tail<3>() *= angle / xi.tail<3>().norm();
    second = first * element.start * exp_motion(xi);
    element.lumen = vec6(0.3, -0.2, 1.7, 0.1, -0.6, 0.4);
  }
  double energy(const Vec12& eta) const {
    return element_energy(element, first * exp_motion(eta.head<6>()),
                          second * exp_motion(eta.tail<6>()));
  }
};

const double angles[] = {0, 1e-3, 0.7, 1.3, 2.9};

TEST(Energy, GradientMatchesDifferences) {
  for (const double angle : angles) {
    const Fixture f(angle);
    const Vec12 gradient = element_energy_gradient(f.element, f.first, f.second);
    const double h = 1e-5;
    for (int k = 0; k < 12; ++k) {
      const Vec12 e = h * Vec12::Unit(k);
      EXPECT_NEAR(gradient[k], (f.energy(e) - f.energy(-e)) / (2 * h), 2e-8 * gradient.norm())
          << angle << ' ' << k;
    }
  }
}

TEST(Energy, HessianIsTheSecondDerivativeAlongTheExponential) {
  for (const double angle : angles) {
    const Fixture f(angle);
    const Vec6 stress = element_stress(f.element, element_strain(f.element, f.first, f.second));
    const Mat12 hessian = element_energy_hessian(f.element, f.first, f.second, stress);
    const double h = 1e-3;
    const double e0 = f.energy(Vec12::Zero());
    // second difference along d, fourth order
    const auto second = [&](const Vec12& d) {
      return (-f.energy(2 * h * d) + 16 * f.energy(h * d) - 30 * e0 + 16 * f.energy(-h * d) -
              f.energy(-2 * h * d)) /
             (12 * h * h);
    };
    for (int i = 0; i < 12; ++i)
      for (int j = 0; j <= i; ++j) {
        const Vec12 a = Vec12::Unit(i), b = Vec12::Unit(j);
        const double expected = i == j ? second(a) : (second(a + b) - second(a - b)) / 4;
        EXPECT_NEAR(hessian(i, j), expected, 2e-8 * hessian.norm())
            << angle << ' ' << i << ' ' << j;
        EXPECT_NEAR(hessian(i, j), hessian(j, i), 1e-15 * hessian.norm()) << i << ' ' << j;
      }
  }
}

TEST(Energy, GeometricTermIsLinearInTheGivenStress) {
  const Fixture f(0.9);
  const Mat12 zero = element_energy_hessian(f.element, f.first, f.second, Vec6::Zero());
  const Vec6 s = vec6(1, 2, -3, 0.5, -0.2, 0.7);
  const Mat12 one = element_energy_hessian(f.element, f.first, f.second, s) - zero;
  const Mat12 two = element_energy_hessian(f.element, f.first, f.second, 2 * s) - zero;
  EXPECT_GT(one.norm(), 1);
  EXPECT_LT((two - 2 * one).norm(), 1e-12 * two.norm());
}

TEST(Energy, RigidMotionsCostNothing) {
  const Fixture f(1.3);
  const Pose g = exp_motion(vec6(-30, 20, 5, 1.0, 2.0, -0.5));
  const double e = element_energy(f.element, f.first, f.second);
  EXPECT_NEAR(element_energy(f.element, g * f.first, g * f.second), e, 1e-13 * std::abs(e));
  // the gradient does no work on a rigid motion, expressed in both body frames
  const Vec6 twist = vec6(0.3, -0.5, 0.2, 0.7, 0.1, -0.9);
  Vec12 rigid;
  rigid << adjoint(f.first.inverse()) * twist, adjoint(f.second.inverse()) * twist;
  const Vec12 gradient = element_energy_gradient(f.element, f.first, f.second);
  EXPECT_NEAR(gradient.dot(rigid), 0, 1e-13 * gradient.norm() * rigid.norm());
}

TEST(Energy, StressFreeAtTheNaturalStrain) {
  Fixture f(0);
  f.second = f.first * f.element.start * exp_motion(f.element.length * f.element.natural_strain);
  // all that is left is the lumen's
  EXPECT_NEAR(element_energy(f.element, f.first, f.second),
              -f.element.length * f.element.lumen.dot(f.element.natural_strain), 1e-14);
  EXPECT_LT((element_stress(f.element, f.element.natural_strain) + f.element.lumen).norm(), 1e-14);
  f.element.lumen.setZero();
  EXPECT_LT(element_energy(f.element, f.first, f.second), 1e-28);
  EXPECT_LT(element_energy_gradient(f.element, f.first, f.second).norm(), 1e-13);
}

}  // namespace
}  // namespace vasorod
