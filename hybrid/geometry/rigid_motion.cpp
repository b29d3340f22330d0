#include "geometry/rigid_motion.h"

#include <Eigen/Geometry>
#include <Eigen/SVD>
#include <cmath>

namespace vasorod {

ExpCoefficients exp_coefficients(double z) {
  if (z > 0.5) {
    const double a = std::sqrt(z);
    const double half = std::sin(a / 2);
    const double b = 2 * half * half / z;
    const double d = (a - std::sin(a)) / (z * a);
    return {b, d, (std::sin(a) / a - 2 * b) / z, (b - 3 * d) / z};
  }
  // b = sum (-z)^k / (2k + 2)!, d = sum (-z)^k / (2k + 3)!; b2 and d2 are twice their derivatives
  // by z. Horner's scheme, with the terms that z = 0.5 needs for full precision.
  const double b =
      1. / 2 -
      z * (1. / 24 -
           z * (1. / 720 - z * (1. / 40320 - z * (1. / 3628800 - z * (1. / 479001600 -
                                                                      z * (1. / 87178291200.))))));
  const double d =
      1. / 6 -
      z * (1. / 120 -
           z * (1. / 5040 -
                z * (1. / 362880 -
                     z * (1. / 39916800 - z * (1. / 6227020800. - z * (1. / 1307674368000.))))));
  const double b2 =
      -2 * (1. / 24 -
            z * (2. / 720 - z * (3. / 40320 - z * (4. / 3628800 - z * (5. / 479001600 -
                                                                       z * (6. / 87178291200.))))));
  const double d2 =
      -2 * (1. / 120 -
            z * (2. / 5040 -
                 z * (3. / 362880 -
                      z * (4. / 39916800 - z * (5. / 6227020800. - z * (6. / 1307674368000.))))));
  return {b, d, b2, d2};
}

LogCoefficients log_coefficients(double z) {
  if (z > 1.0) {
    const double a = std::sqrt(z), sine = std::sin(a / 2), cosine = std::cos(a / 2);
    const double h = a / 2 * cosine / sine;  // a/2 cot(a/2) and its derivatives by a
    const double h1 = cosine / (2 * sine) - a / (4 * sine * sine);
    const double h2 = (h - 1) / (2 * sine * sine);
    const double c = (1 - h) / z;
    const double c2 = (-h1 / a - 2 * c) / z;
    // c'' = -h2/z + 4 h1/(z a) + 6 c/z and c3 = (c'' - c2) / z
    const double c3 = ((-h2 + 4 * h1 / a + 6 * c) / z - c2) / z;
    return {c, c2, c3};
  }
  // c = sum |B_(2k+2)| / (2k+2)! z^k; ratio of terms at z = 1 is 1/39.5.
  constexpr double a0 = 1. / 12, a1 = 1. / 720, a2 = 1. / 30240, a3 = 1. / 1209600,
                   a4 = 1. / 47900160, a5 = 691. / 1307674368000., a6 = 1. / 74724249600.,
                   a7 = 3617. / 10670622842880000., a8 = 43867. / 5109094217170944000.,
                   a9 = 174611. / 802857662698291200000.;
  const double c =
      a0 +
      z * (a1 +
           z * (a2 + z * (a3 + z * (a4 + z * (a5 + z * (a6 + z * (a7 + z * (a8 + z * a9))))))));
  const double c2 =
      2 *
      (a1 +
       z * (2 * a2 +
            z * (3 * a3 +
                 z * (4 * a4 +
                      z * (5 * a5 + z * (6 * a6 + z * (7 * a7 + z * (8 * a8 + z * 9 * a9))))))));
  const double c3 =
      4 * (2 * a2 +
           z * (6 * a3 +
                z * (12 * a4 +
                     z * (20 * a5 + z * (30 * a6 + z * (42 * a7 + z * (56 * a8 + z * 72 * a9)))))));
  return {c, c2, c3};
}

Mat3 exp_rotation(const Vec3& vector) {
  const double z = vector.squaredNorm();
  const ExpCoefficients k = exp_coefficients(z);
  const Mat3 h = hat(vector);
  return Mat3::Identity() + (1 - z * k.d) * h + k.b * h * h;
}

Vec3 log_rotation(const Mat3& rotation) {
  // Uses the quaternion: its vector part is accurate at both ends of the range. The skew part of
  // the matrix loses the axis near pi, and its trace loses the angle near 0.
  const Eigen::Quaterniond q(rotation);
  const double s = q.vec().norm();
  if (s < 1e-150) return 2 * q.vec() / (q.w() < 0 ? -1 : 1);
  const double angle = q.w() < 0 ? 2 * std::atan2(-s, -q.w()) : 2 * std::atan2(s, q.w());
  return q.vec() * (angle / s);
}

Mat3 left_jacobian(const Vec3& vector) {
  const ExpCoefficients k = exp_coefficients(vector.squaredNorm());
  const Mat3 h = hat(vector);
  return Mat3::Identity() + k.b * h + k.d * h * h;
}
Mat3 right_jacobian(const Vec3& vector) {
  return left_jacobian(Vec3(-vector));
}

Mat3 left_jacobian_inverse(const Vec3& vector) {
  const Mat3 h = hat(vector);
  return Mat3::Identity() - 0.5 * h + log_coefficients(vector.squaredNorm()).c * h * h;
}
Mat3 right_jacobian_inverse(const Vec3& vector) {
  return left_jacobian_inverse(Vec3(-vector));
}

Pose exp_motion(const Vec6& twist) {
  const Vec3 v = twist.head<3>(), u = twist.tail<3>();
  const double z = u.squaredNorm();
  const ExpCoefficients k = exp_coefficients(z);
  const Mat3 h = hat(u);
  const Vec3 uv = u.cross(v);
  return {Mat3::Identity() + (1 - z * k.d) * h + k.b * h * h, v + k.b * uv + k.d * u.cross(uv)};
}

Vec6 log_motion(const Pose& motion) {
  const Vec3 u = log_rotation(motion.rotation);
  const Vec3 cross = u.cross(motion.position);
  Vec6 twist;
  twist << motion.position - 0.5 * cross + log_coefficients(u.squaredNorm()).c * u.cross(cross), u;
  return twist;
}

// A twist is a rotation vector over the dual numbers, u + eps v. The coupling block of each 6 x 6
// Jacobian is therefore the derivative of the 3 x 3 Jacobian in the direction v.
Mat6 left_jacobian(const Vec6& twist) {
  const Vec3 v = twist.head<3>(), u = twist.tail<3>();
  const ExpCoefficients k = exp_coefficients(u.squaredNorm());
  const Mat3 hu = hat(u), hv = hat(v), uu = hu * hu;
  const double uv = u.dot(v);
  Mat6 j = Mat6::Zero();
  j.topLeftCorner<3, 3>() = j.bottomRightCorner<3, 3>() = Mat3::Identity() + k.b * hu + k.d * uu;
  j.topRightCorner<3, 3>() = k.b * hv + k.d * (hu * hv + hv * hu) + uv * (k.b2 * hu + k.d2 * uu);
  return j;
}
Mat6 right_jacobian(const Vec6& twist) {
  return left_jacobian(Vec6(-twist));
}

Mat6 left_jacobian_inverse(const Vec6& twist) {
  const Vec3 v = twist.head<3>(), u = twist.tail<3>();
  const LogCoefficients k = log_coefficients(u.squaredNorm());
  const Mat3 hu = hat(u), hv = hat(v), uu = hu * hu;
  Mat6 j = Mat6::Zero();
  j.topLeftCorner<3, 3>() = j.bottomRightCorner<3, 3>() = Mat3::Identity() - 0.5 * hu + k.c * uu;
  j.topRightCorner<3, 3>() = -0.5 * hv + k.c * (hu * hv + hv * hu) + u.dot(v) * k.c2 * uu;
  return j;
}
Mat6 right_jacobian_inverse(const Vec6& twist) {
  return left_jacobian_inverse(Vec6(-twist));
}

Mat6 adjoint(const Pose& motion) {
  Mat6 a = Mat6::Zero();
  a.topLeftCorner<3, 3>() = a.bottomRightCorner<3, 3>() = motion.rotation;
  a.topRightCorner<3, 3>() = hat(motion.position) * motion.rotation;
  return a;
}

Pose interpolate(const Pose& a, const Pose& b, double t) {
  return a * exp_motion(t * log_motion(a.inverse() * b));
}

Mat3 nearest_rotation(const Mat3& matrix) {
  return Eigen::Quaterniond(matrix).normalized().toRotationMatrix();
}

Mat3 rotation_part(const Mat3& matrix) {
  const Eigen::JacobiSVD<Mat3> svd(matrix, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Mat3 sign = Mat3::Identity();
  sign(2, 2) = (svd.matrixU() * svd.matrixV().transpose()).determinant();
  return svd.matrixU() * sign * svd.matrixV().transpose();
}

}  // namespace vasorod
