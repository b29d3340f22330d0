#include "wall/membrane_strain.h"

#include <algorithm>
#include <cmath>

namespace vasorod {

namespace {

// The stretch U of C = U U in two dimensions by Cayley and Hamilton, without eigenvalues:
// U = (C + det U I) / tr U.
struct Stretch {
  double u11, u22, u12, trace, det;
  explicit Stretch(const Vec3& c) {
    // A triangle collapsed to a line keeps a finite energy and finite forces.
    det = std::sqrt(std::max(c[0] * c[1] - c[2] * c[2], 1e-24));
    trace = std::sqrt(c[0] + c[1] + 2 * det);
    u11 = (c[0] + det) / trace;
    u22 = (c[1] + det) / trace;
    u12 = c[2] / trace;
  }
};

// The map dC -> dU of U dU + dU U = dC in the storage above:
//   dU = (det U dC + V dC V) / (2 tr U det U),   V = tr U I - U the adjugate of U.
Mat3 stretch_derivative(const Stretch& s) {
  const double v11 = s.u22, v22 = s.u11, v12 = -s.u12;
  Mat3 d;
  d << s.det + v11 * v11, v12 * v12, 2 * v11 * v12,  //
      v12 * v12, s.det + v22 * v22, 2 * v12 * v22,   //
      2 * v11 * v12, 2 * v12 * v22, 2 * (s.det + v11 * v22 + v12 * v12);
  return d / (2 * s.trace * s.det);
}

}  // namespace

MembraneStrain membrane_strain(Law law, const Vec3& c) {
  if (law == Law::svk)
    return {Vec3((c[0] - 1) / 2, (c[1] - 1) / 2, c[2]), Vec3(0.5, 0.5, 1).asDiagonal()};
  const Stretch s(c);
  return {Vec3(s.u11 - 1, s.u22 - 1, 2 * s.u12), stretch_derivative(s)};
}

Mat3 membrane_strain_hessian(Law law, const Vec3& c, const Vec3& stress) {
  if (law == Law::svk) return Mat3::Zero();
  // With T the solution of U T + T U = stress:
  //   stress : d2U = -2 T : (dU dU)
  // for the same dC in both directions and d2C = 0.
  const Stretch s(c);
  const Mat3 d = stretch_derivative(s);
  const Vec3 t(d.col(0).dot(stress), d.col(1).dot(stress), d.col(2).dot(stress) / 2);
  Mat3 q;                  // T : (dU dU) as a quadratic form in (dU11, dU22, 2 dU12)
  q << t[0], 0, t[2] / 2,  //
      0, t[1], t[2] / 2,   //
      t[2] / 2, t[2] / 2, (t[0] + t[1]) / 4;
  return -2 * d.transpose() * q * d;
}

}  // namespace vasorod
