// Follower pressure on the shell's inner face x = R + u - t/2 (D + w). The force on that face is
// p n da, with n da = (A e1) x (A e2) dA, A = P + grad u - t/2 (grad D + grad w) and e1, e2 tangent
// to the mid-surface, with e1 x e2 on the side of D.
#include <Eigen/Geometry>

#include "geometry/rigid_motion.h"
#include "reference_fem/shell.h"

namespace vasorod::fem {

using std::size_t;

void Shell::press(int cell, const DofValues& u, double load, bool want_tangent,
                  CellTerms& terms) const {
  const auto c = static_cast<size_t>(cell);
  const auto n = static_cast<Eigen::Index>(mesh_.cell_nodes[c].size());
  const NodeValues at = values_of(c, u);
  const Eigen::MatrixX3d directors = at.D + at.w;  // current
  for (Eigen::Index q = 0; q < mesh_.point_count(); ++q) {
    const auto gradient = mesh_.gradient[c].middleRows<3>(3 * q);
    const Vec3 director = (mesh_.shape.row(q) * at.D).transpose(), on_mesh = mesh_.normal[c].col(q);
    const Vec3 normal = director.dot(on_mesh) < 0 ? Vec3(-on_mesh) : on_mesh,
               e1 = normal.unitOrthogonal(), e2 = normal.cross(e1);
    const double half = thickness_[c][q] / 2;
    const Mat3 A = Mat3::Identity() + (gradient * (at.u - half * directors)).transpose();
    const Vec3 along = A * e1, across = A * e2, area = along.cross(across);
    const double p = pressure_at(pressure_, load) * mesh_.weights[c][q];
    const Eigen::VectorXd N = mesh_.shape.row(q);
    for (Eigen::Index i = 0; i < 3; ++i) {
      terms.residual.segment(i * n, n) -= p * area[i] * N;
      terms.residual.segment((3 + i) * n, n) += half * p * area[i] * N;
    }
    if (!want_tangent) continue;
    const Eigen::VectorXd g1 = gradient.transpose() * e1, g2 = gradient.transpose() * e2;
    const Mat3 turn_along = hat(along), turn_across = hat(across);
    for (Eigen::Index i = 0; i < 3; ++i)
      for (Eigen::Index k = 0; k < 3; ++k) {
        if (i == k) continue;
        const Eigen::MatrixXd block =
            -p * N * (turn_along(i, k) * g2 - turn_across(i, k) * g1).transpose();
        terms.tangent.block(i * n, k * n, n, n) += block;
        terms.tangent.block(i * n, (3 + k) * n, n, n) -= half * block;
        terms.tangent.block((3 + i) * n, k * n, n, n) -= half * block;
        terms.tangent.block((3 + i) * n, (3 + k) * n, n, n) += half * half * block;
      }
  }
}

}  // namespace vasorod::fem
