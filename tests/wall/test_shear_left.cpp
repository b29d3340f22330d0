#include <cmath>
#include <gtest/gtest.h>

#include "wall/plane_stress.h"
#include "wall/shear_left.h"

namespace vasorod {
namespace {

// An equilateral triangle with edges of length h, one of them along y.
Eigen::Matrix<double, 2, 3> equilateral(double h) {
  const double height = h * std::sqrt(0.75);
  Eigen::Matrix<double, 2, 3> gradients;
  gradients << 1 / height, -0.5 / height, -0.5 / height, 0, 1 / h, -1 / h;
  return gradients;
}

// By hand for an equilateral triangle without Poisson's effect (ring_softness.h): the bending
// varies within it by h^2 / 24, and v = (1, -1/8, -1/8) h / sqrt(12) with P^T P = 3/4 I + 1/4 J
// gives 5 h^2 / 48.
TEST(ShearLeft, FallsWithTheSquareOfTheTriangle) {
  WallSection section;
  section.inner = -0.5;
  section.outer = 0.5;
  section.stiffness = plane_stress(Material::isotropic(1, 0));
  section.shear_modulus.setConstant(0.5);
  const double ratio = (1.0 / 12) / (5.0 / 6 * 0.5);  // D / S
  const auto lost = [&](double h) {
    return (1 - shear_left(equilateral(h), section, Vec2::UnitX())) * ratio / (h * h);
  };
  for (const double h : {0.01, 0.1, 1.0, 10.0}) EXPECT_NEAR(lost(h), 7.0 / 48, 1e-12);
}

}  // namespace
}  // namespace vasorod
