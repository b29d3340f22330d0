#include "rod/energy.h"

#include "geometry/rigid_motion.h"

namespace vasorod {

Vec6 element_strain(const RodElement& element, const Pose& first, const Pose& second) {
  return log_motion((first * element.start).inverse() * second) / element.length;
}

Vec6 element_stress(const RodElement& element, const Vec6& strain) {
  return element.stiffness * (strain - element.natural_strain) - element.lumen;
}

double element_energy(const RodElement& element, const Pose& first, const Pose& second) {
  const Vec6 strain = element_strain(element, first, second), e = strain - element.natural_strain;
  return element.length * (0.5 * e.dot(element.stiffness * e) - element.lumen.dot(strain));
}

Vec12 element_energy_gradient(const RodElement& element, const Pose& first, const Pose& second) {
  const Vec6 xi = log_motion((first * element.start).inverse() * second);
  const Vec6 stress = element_stress(element, xi / element.length);
  const Vec6 wrench = right_jacobian_inverse(xi).transpose() * stress;
  Vec12 gradient;
  gradient << -adjoint(second.inverse() * first).transpose() * wrench, wrench;
  return gradient;
}

// With p = u x (u x n): Jr^-T(u) n = n - u x n / 2 + c p.
Mat3 right_jacobian_inverse_transposed_derivative(const Vec3& u, const Vec3& n) {
  const LogCoefficients k = log_coefficients(u.squaredNorm());
  const Vec3 p = u.cross(u.cross(n));
  return 0.5 * hat(n) +
         k.c * (u * n.transpose() + u.dot(n) * Mat3::Identity() - 2 * n * u.transpose()) +
         k.c2 * p * u.transpose();
}

namespace {

// Derivative of right_jacobian_inverse_transposed_derivative(u, n) with respect to u in the
// direction v.
Mat3 second_derivative(const Vec3& u, const Vec3& v, const Vec3& n) {
  const LogCoefficients k = log_coefficients(u.squaredNorm());
  const double un = u.dot(n), vn = v.dot(n), uv = u.dot(v);
  const Vec3 p = u.cross(u.cross(n));
  const Vec3 p_v = v * un + u * vn - 2 * n * uv;  // derivative of p in the direction v
  return k.c * (v * n.transpose() + vn * Mat3::Identity() - 2 * n * v.transpose()) +
         k.c2 * uv * (u * n.transpose() + un * Mat3::Identity() - 2 * n * u.transpose()) +
         k.c2 * (p_v * u.transpose() + p * v.transpose()) + k.c3 * uv * p * u.transpose();
}

}  // namespace

Mat6 geometric_stiffness(const Vec6& xi, const Vec6& stress) {
  const Vec3 v = xi.head<3>(), u = xi.tail<3>(), n = stress.head<3>(), m = stress.tail<3>();
  const Mat3 xn = right_jacobian_inverse_transposed_derivative(u, n);
  Mat6 derivative = Mat6::Zero();  // of Jr^-T(xi) stress with respect to xi
  derivative.topRightCorner<3, 3>() = derivative.bottomLeftCorner<3, 3>() = xn;
  derivative.bottomRightCorner<3, 3>() =
      right_jacobian_inverse_transposed_derivative(u, m) + second_derivative(u, v, n);
  const Mat6 g = right_jacobian(xi).transpose() * derivative;
  return 0.5 * (g + g.transpose());
}

Mat12 element_energy_hessian(const RodElement& element, const Pose& first, const Pose& second,
                             const Vec6& stress) {
  const Pose h = first.inverse() * second;
  const Vec6 xi = log_motion(element.start.inverse() * h);
  const Mat6 jr = right_jacobian_inverse(xi);
  // With a = -adjoint(h^-1) eta_first and b = eta_second: h -> h exp(b'),
  //   b' = a + b + [a, b] / 2 + ...
  const Mat6 k =
      jr.transpose() * (element.stiffness / element.length + geometric_stiffness(xi, stress)) * jr;
  const Vec6 wrench = jr.transpose() * stress;
  Mat6 bracket = Mat6::Zero();  // a^T bracket b = wrench . [a, b] / 2
  bracket.topRightCorner<3, 3>() = bracket.bottomLeftCorner<3, 3>() = -0.5 * hat(wrench.head<3>());
  bracket.bottomRightCorner<3, 3>() = -0.5 * hat(wrench.tail<3>());
  const Mat6 a = -adjoint(h.inverse());
  Mat12 hessian;
  hessian.topLeftCorner<6, 6>() = a.transpose() * k * a;
  hessian.topRightCorner<6, 6>() = a.transpose() * (k + bracket);
  hessian.bottomLeftCorner<6, 6>() = hessian.topRightCorner<6, 6>().transpose();
  hessian.bottomRightCorner<6, 6>() = k;
  return hessian;
}

}  // namespace vasorod
