#include <Eigen/LU>
#include <gtest/gtest.h>

#include "wall/plane_stress.h"
#include "wall/ring_softness.h"

namespace vasorod {
namespace {

Eigen::Matrix<double, 2, 3> gradients_of(const Vec2& x1, const Vec2& x2) {
  Eigen::Matrix2d edges;
  edges << x1, x2;
  Eigen::Matrix<double, 2, 3> gradients;
  gradients.rightCols<2>() = edges.inverse().transpose();
  gradients.col(0) = -gradients.col(1) - gradients.col(2);
  return gradients;
}

// Triangles far longer along the axis (length H) than around. The slopes s of the two long edges
// alternate between a twist d = 2 delta s / H and a bending reduced by delta. With
// w = 8 (1 - nu) / (H k)^2, the best delta leaves w / (1 + w).
TEST(RingSoftness, LongTrianglesByHand) {
  const double nu = 0.3, height = 5, base = 0.01, radius = 10;
  const Mat3 d = plane_stress(Material::isotropic(1, nu));
  const double k = 2 / radius;
  EXPECT_NEAR(ring_softness(gradients_of({0, base}, {height, base / 2}), d, Vec2(0, 1), 1 / radius),
              height * height * k * k / (8 * (1 - nu)), 1e-4);
}

TEST(RingSoftness, SecondOrderAndAFrameOfItsOwn) {
  const Mat3 d = plane_stress(Material::isotropic(1, 0.3));
  const Vec2 x1(1, 0.2), x2(0.3, 0.8), x(0.6, 0.8);
  const double s = ring_softness(gradients_of(x1, x2), d, x, 0.1);
  EXPECT_GT(s, 0);
  EXPECT_NEAR(ring_softness(gradients_of(0.5 * x1, 0.5 * x2), d, x, 0.1), s / 4, 1e-15);
  EXPECT_NEAR(ring_softness(gradients_of(x2 - x1, -x1), d, x, 0.1), s, 1e-14);
  Eigen::Matrix2d turn;  // an isotropic wall has no preferred direction
  turn << 0.8, -0.6, 0.6, 0.8;
  EXPECT_NEAR(ring_softness(gradients_of(turn * x1, turn * x2), d, turn * x, 0.1), s, 1e-14);
  EXPECT_EQ(ring_softness(gradients_of(x1, x2), d, x, 0), 0);
}

}  // namespace
}  // namespace vasorod
