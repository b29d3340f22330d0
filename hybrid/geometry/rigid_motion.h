// Rotations SO(3) and rigid motions SE(3): exponential, logarithm and their derivatives.
//
// A rotation vector is axis times angle (radians). A twist is (v, u): translation part first,
// rotation part second, the order of the rod's strains. Every rigid motion is the exponential of a
// twist. A two-node rod element uses one logarithm, so stretch, shear, twist, arcs and helices are
// exact in it (Sonneville, Cardona and Bruls 2014). Jacobians follow the usual convention:
// exp(x + dx) = exp(Jl(x) dx) exp(x) = exp(x) exp(Jr(x) dx) to first order.
#pragma once

#include <Eigen/Geometry>

#include <vasorod/types.h>

namespace vasorod {

/// Matrix of the cross product: hat(a) b = a x b.
inline Mat3 hat(const Vec3& a) {
  Mat3 m;
  m << 0, -a.z(), a.y(), a.z(), 0, -a.x(), -a.y(), a.x(), 0;
  return m;
}

/// Rotation by |vector| about its direction (Rodrigues); any angle.
Mat3 exp_rotation(const Vec3& vector);
/// Rotation vector of a rotation, angle in [0, pi]; accurate from 0 up to and including pi.
Vec3 log_rotation(const Mat3& rotation);

Mat3 left_jacobian(const Vec3& vector);
Mat3 right_jacobian(const Vec3& vector);
/// Inverses; singular at 2 pi.
Mat3 left_jacobian_inverse(const Vec3& vector);
Mat3 right_jacobian_inverse(const Vec3& vector);

/// Rigid motion exp(twist), twist = (v, u).
Pose exp_motion(const Vec6& twist);
/// Twist (v, u) of a rigid motion, |u| in [0, pi].
Vec6 log_motion(const Pose& motion);

Mat6 left_jacobian(const Vec6& twist);
Mat6 right_jacobian(const Vec6& twist);
Mat6 left_jacobian_inverse(const Vec6& twist);
Mat6 right_jacobian_inverse(const Vec6& twist);

/// Adjoint: g exp(x) g^-1 = exp(adjoint(g) x).
Mat6 adjoint(const Pose& motion);

/// The pose at fraction t of the way from a to b along the screw that joins them.
Pose interpolate(const Pose& a, const Pose& b, double t);

/// The rotation nearest to a matrix that is a rotation up to round-off.
Mat3 nearest_rotation(const Mat3& matrix);

/// The rotation nearest to any matrix, that of its polar decomposition where the determinant is
/// positive; a rotation for reflections and singular matrices too (Kabsch 1976).
Mat3 rotation_part(const Mat3& matrix);

/// Coefficients of exp and its Jacobians as functions of z = angle^2, accurate down to 0:
/// b = (1 - cos a) / a^2, d = (a - sin a) / a^3, b2 = b'(a) / a, d2 = d'(a) / a.
struct ExpCoefficients {
  double b, d, b2, d2;
};
ExpCoefficients exp_coefficients(double z);

/// Coefficients of the inverse Jacobians, angle below 2 pi:
/// c = (1 - a/2 cot(a/2)) / a^2, c2 = c'(a) / a, c3 = c2'(a) / a.
struct LogCoefficients {
  double c, c2, c3;
};
LogCoefficients log_coefficients(double z);

}  // namespace vasorod
