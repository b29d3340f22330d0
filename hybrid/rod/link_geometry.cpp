#include "rod/link_geometry.h"

#include "geometry/rigid_motion.h"
#include "rod/small_products.h"

namespace vasorod {

// With p(m) = u x (u x m) = u (u.m) - m z and z = |u|^2:
//
//   Jr^-T(u) n = n - u x n / 2 + c p(n)
//
// and its derivative with respect to u
//
//   X(n) = hat(n)/2 + c (u n^T + (u.n) 1 - 2 n u^T) + c2 p(n) u^T
//
// The derivative of the moment is X(m) plus the derivative of X(n) in the direction v (twists are
// dual numbers).
VASOROD_VECTORIZED
LinkGeometry link_geometry(const Vec6& xi, const Vec6& stress) {
  const Vec3 v = xi.head<3>(), u = xi.tail<3>(), n = stress.head<3>(), m = stress.tail<3>();
  const double z = u.squaredNorm(), uv = u.dot(v), un = u.dot(n), um = u.dot(m), vn = v.dot(n);
  const ExpCoefficients e = exp_coefficients(z);
  const LogCoefficients l = log_coefficients(z);
  LinkGeometry g;

  const Vec3 du = e.d * u;
  g.j.noalias() = du * u.transpose();
  g.j -= hat(e.b * u);
  g.j.diagonal().array() += 1 - e.d * z;
  const Vec3 row = e.d * v + (uv * e.d2) * u;
  g.b.noalias() = row * u.transpose();
  g.b.noalias() += du * v.transpose();
  g.b -= hat((uv * e.b2) * u + e.b * v);
  g.b.diagonal().array() -= uv * (2 * e.d + e.d2 * z);

  const Vec3 pn = un * u - z * n, pm = um * u - z * m;
  const Vec3 pv = un * v + vn * u - (2 * uv) * n;  // derivative of p(n) in the direction v
  g.force = n - 0.5 * u.cross(n) + l.c * pn;
  g.moment = m - 0.5 * (u.cross(m) + v.cross(n)) + l.c * (pm + pv) + (l.c2 * uv) * pn;

  const Vec3 side = l.c2 * pn - (2 * l.c) * n;
  Mat3 xn;
  xn.noalias() = (l.c * u) * n.transpose();
  xn.noalias() += side * u.transpose();
  xn += hat(0.5 * n);
  xn.diagonal().array() += l.c * un;
  Mat3 y;
  y.noalias() = u * (l.c * m + (l.c2 * uv) * n).transpose();
  y.noalias() +=
      (l.c2 * (pm + pv) - (2 * l.c) * m + uv * (l.c3 * pn - (2 * l.c2) * n)) * u.transpose();
  y.noalias() += (l.c * v) * n.transpose();
  y.noalias() += side * v.transpose();
  y += hat(0.5 * m);
  y.diagonal().array() += l.c * (um + vn) + l.c2 * uv * un;

  const Mat3 jx = transposed_times(g.j, xn), by = transposed_times(g.b, xn, g.j, y);
  g.g12 = 0.5 * (jx + jx.transpose());
  g.g22 = 0.5 * (by + by.transpose());
  return g;
}

}  // namespace vasorod
