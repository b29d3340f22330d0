#include <Eigen/LU>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <unsupported/Eigen/MatrixFunctions>

#include "geometry/rigid_motion.h"

namespace vasorod {
namespace {

const Vec3 axis = Vec3(0.3, -0.7, 0.5).normalized();
const double angles[] = {0,       1e-9,    1e-4, 0.3, 0.70710678, 0.7072,
                         0.99999, 1.00001, 2.0,  3.0, 3.1415926};

Vec6 twist_with_angle(double angle) {
  Vec6 x;
  x << 0.4, -1.1, 0.8, angle * axis;
  return x;
}

// Central differences of a function of a twist; h = 1e-5 leaves 1e-10.
template <class F>
Mat6 difference(const F& f) {
  Mat6 j;
  const double h = 1e-5;
  for (int k = 0; k < 6; ++k) j.col(k) = (f(h * Vec6::Unit(k)) - f(-h * Vec6::Unit(k))) / (2 * h);
  return j;
}

TEST(RigidMotion, ExpIsTheMatrixExponential) {
  for (const double angle : angles) {
    const Vec6 x = twist_with_angle(angle);
    Eigen::Matrix4d generator = Eigen::Matrix4d::Zero();
    generator.topLeftCorner<3, 3>() = hat(x.tail<3>());
    generator.topRightCorner<3, 1>() = x.head<3>();
    const Eigen::Matrix4d expected = generator.exp();
    const Pose g = exp_motion(x);
    EXPECT_LT((g.rotation - expected.topLeftCorner<3, 3>()).norm(), 1e-14) << angle;
    EXPECT_LT((g.position - expected.topRightCorner<3, 1>()).norm(), 1e-14) << angle;
    EXPECT_LT((exp_rotation(x.tail<3>()) - g.rotation).norm(), 1e-15);
  }
}

TEST(RigidMotion, ExpTakesAngleBeyondATurn) {
  const Vec3 turn = axis * (2 * std::numbers::pi + 0.4);
  EXPECT_LT((exp_rotation(turn) - exp_rotation(0.4 * axis)).norm(), 1e-14);
}

TEST(RigidMotion, LogUndoesExp) {
  for (const double angle : angles) {
    const Vec6 x = twist_with_angle(angle);
    EXPECT_LT((log_motion(exp_motion(x)) - x).norm(), 4e-15) << angle;
  }
}

TEST(RigidMotion, LogAtExactlyHalfATurn) {
  for (const Vec3& a : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1), axis}) {
    const Mat3 r = 2 * a * a.transpose() - Mat3::Identity();
    const Vec3 u = log_rotation(r);
    EXPECT_NEAR(u.norm(), std::numbers::pi, 1e-14);
    EXPECT_NEAR(std::abs(u.normalized().dot(a)), 1, 1e-14);
  }
}

TEST(RigidMotion, SmallAnglesKeepRelativeAccuracy) {
  const Vec3 u = 1e-12 * axis;
  EXPECT_LT((log_rotation(exp_rotation(u)) - u).norm(), 1e-15 * 1e-12 + 1e-16 * 1e-12);
}

TEST(RigidMotion, JacobiansAreTheDerivativesOfExp) {
  for (const double angle : angles) {
    const Vec6 x = twist_with_angle(angle);
    const Pose inverse = exp_motion(x).inverse();
    const Mat6 left =
        difference([&](const Vec6& d) { return log_motion(exp_motion(x + d) * inverse); });
    const Mat6 right =
        difference([&](const Vec6& d) { return log_motion(inverse * exp_motion(x + d)); });
    EXPECT_LT((left_jacobian(x) - left).norm(), 1e-9) << angle;
    EXPECT_LT((right_jacobian(x) - right).norm(), 1e-9) << angle;
    const Vec3 u = x.tail<3>();
    EXPECT_LT((left_jacobian(u) - left.bottomRightCorner<3, 3>()).norm(), 1e-9);
    EXPECT_LT((right_jacobian(u) - right.bottomRightCorner<3, 3>()).norm(), 1e-9);
  }
}

TEST(RigidMotion, InverseJacobians) {
  for (const double angle : angles) {
    const Vec6 x = twist_with_angle(angle);
    EXPECT_LT((left_jacobian(x) * left_jacobian_inverse(x) - Mat6::Identity()).norm(), 1e-13)
        << angle;
    EXPECT_LT((right_jacobian(x) * right_jacobian_inverse(x) - Mat6::Identity()).norm(), 1e-13)
        << angle;
    const Vec3 u = x.tail<3>();
    EXPECT_LT((left_jacobian(u) * left_jacobian_inverse(u) - Mat3::Identity()).norm(), 1e-14);
    EXPECT_LT((right_jacobian(u) * right_jacobian_inverse(u) - Mat3::Identity()).norm(), 1e-14);
  }
}

TEST(RigidMotion, CoefficientsAreContinuousWhereTheFormulaChanges) {
  const ExpCoefficients e0 = exp_coefficients(0.5), e1 = exp_coefficients(0.5 * (1 + 1e-15));
  EXPECT_NEAR(e0.b, e1.b, 1e-15);
  EXPECT_NEAR(e0.d, e1.d, 1e-15);
  EXPECT_NEAR(e0.b2, e1.b2, 3e-14);
  EXPECT_NEAR(e0.d2, e1.d2, 3e-14);
  const LogCoefficients l0 = log_coefficients(1), l1 = log_coefficients(1 + 1e-15);
  EXPECT_NEAR(l0.c, l1.c, 1e-15);
  EXPECT_NEAR(l0.c2, l1.c2, 1e-14);
  EXPECT_NEAR(l0.c3, l1.c3, 1e-13);
}

TEST(RigidMotion, CoefficientDerivatives) {
  for (const double a : {0.2, 0.8, 1.4, 2.9}) {
    const double h = 1e-5;
    const auto e = [](double x) { return exp_coefficients(x * x); };
    const auto l = [](double x) { return log_coefficients(x * x); };
    EXPECT_NEAR(e(a).b2, (e(a + h).b - e(a - h).b) / (2 * h * a), 1e-9);
    EXPECT_NEAR(e(a).d2, (e(a + h).d - e(a - h).d) / (2 * h * a), 1e-9);
    EXPECT_NEAR(l(a).c2, (l(a + h).c - l(a - h).c) / (2 * h * a), 1e-9);
    EXPECT_NEAR(l(a).c3, (l(a + h).c2 - l(a - h).c2) / (2 * h * a), 1e-9);
  }
}

TEST(RigidMotion, AdjointMovesTwists) {
  const Pose g = exp_motion(twist_with_angle(1.1));
  Vec6 x;
  x << 0.2, 0.1, -0.5, 0.3, 0.9, -0.4;
  const Pose a = g * exp_motion(x) * g.inverse(), b = exp_motion(adjoint(g) * x);
  EXPECT_LT((a.rotation - b.rotation).norm() + (a.position - b.position).norm(), 1e-14);
}

TEST(RigidMotion, InterpolateFollowsTheScrew) {
  const Pose a = exp_motion(twist_with_angle(0.3)), b = exp_motion(twist_with_angle(2.0));
  const Pose middle = interpolate(a, b, 0.5);
  const Vec6 first = log_motion(a.inverse() * middle), second = log_motion(middle.inverse() * b);
  EXPECT_LT((first - second).norm(), 1e-14);
  EXPECT_LT((interpolate(a, b, 1).position - b.position).norm(), 1e-14);
}

// R S with S symmetric and positive has the rotation R; a reflection has none that is nearer.
TEST(RigidMotion, RotationPartIsThatOfThePolarDecomposition) {
  const Mat3 rotation = exp_motion(twist_with_angle(1.3)).rotation;
  Mat3 stretch;
  stretch << 2, 0.3, -0.1, 0.3, 0.5, 0.2, -0.1, 0.2, 1.4;
  EXPECT_LT((rotation_part(rotation * stretch) - rotation).norm(), 1e-14);
  const Mat3 reflected = rotation_part(Mat3(Vec3(1, 1, -0.5).asDiagonal()));
  EXPECT_LT((reflected - Mat3::Identity()).norm(), 1e-14);
  const Mat3 flat = rotation_part(rotation * Mat3(Vec3(3, 2, 0).asDiagonal()));
  EXPECT_LT((flat - rotation).norm(), 1e-14);
}

}  // namespace
}  // namespace vasorod
