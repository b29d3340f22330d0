#include <cmath>
#include <gtest/gtest.h>

#include "geometry/rigid_motion.h"
#include "judge/triangle_strain.h"

namespace vasorod {
namespace {

// A triangle anywhere in space, and its image under a map of its plane.
double strain_of(const Eigen::Matrix2d& map) {
  const Eigen::Matrix<double, 3, 2> flat =
      (Eigen::Matrix<double, 3, 2>() << 0.2, -0.1, 1.3, 0.4, -0.3, 2.1).finished();
  const Mat3 there = exp_rotation(Vec3(0.4, -1.1, 0.7)), back = exp_rotation(Vec3(-2, 0.3, 0.1));
  Points rest(3, 3), current(3, 3);
  for (int k = 0; k < 3; ++k) {
    const Vec2 p = flat.row(k), q = map * p;
    rest.row(k) = there * Vec3(p.x(), p.y(), 0) + Vec3(3, 4, 5);
    current.row(k) = back * Vec3(q.x(), q.y(), 0) - Vec3(1, 2, 3);
  }
  return triangle_strain(rest, current, {0, 1, 2});
}

Eigen::Matrix2d map(double a, double b, double c, double d) {
  return (Eigen::Matrix2d() << a, b, c, d).finished();
}

TEST(TriangleStrain, IsZeroUnderARigidMotion) {
  EXPECT_NEAR(strain_of(map(1, 0, 0, 1)), 0, 1e-14);
}

TEST(TriangleStrain, IsTheLargestChangeOfAPrincipalStretch) {
  EXPECT_NEAR(strain_of(map(1.1, 0, 0, 0.97)), 0.1, 1e-14);
  EXPECT_NEAR(strain_of(map(1.02, 0, 0, 0.7)), 0.3, 1e-14);
  // Simple shear g: the principal stretches are sqrt(1 + g^2 / 4) +- g / 2.
  EXPECT_NEAR(strain_of(map(1, 0.3, 0, 1)), std::sqrt(1 + 0.0225) + 0.15 - 1, 1e-14);
}

TEST(TriangleStrain, ATriangleWithoutAreaAtRestHasNoBound) {
  Points rest = Points::Zero(3, 3), current = Points::Random(3, 3);
  rest(1, 0) = 1;
  EXPECT_TRUE(std::isinf(triangle_strain(rest, current, {0, 1, 2})));
}

}  // namespace
}  // namespace vasorod
