// Bending of the surface [8]:
//
//   E = k_b sum_i |l(p)_i - R_i l(p0)_i|^2
//
// l is the umbrella Laplacian, R_i the rotation of the rod's section at vertex i from rest to the
// present state. k_b in force / length.
#pragma once

#include "geometry/umbrella.h"

namespace vasorod {

/// R_i l(p0)_i, n x 3.
Points carried_laplacian(const Umbrella& umbrella, const Eigen::Ref<const Points>& rest,
                         const std::vector<Mat3>& rotations);

/// Energy, force * length. `p`: n x 3; `carried`: carried_laplacian(), n x 3.
double bending_energy(double k_b, const Umbrella& umbrella, const Eigen::Ref<const Points>& p,
                      const Eigen::Ref<const Points>& carried);

/// gradient += dE/dp (n x 3); returns the energy.
double bending_energy_gradient(double k_b, const Umbrella& umbrella,
                               const Eigen::Ref<const Points>& p,
                               const Eigen::Ref<const Points>& carried,
                               Eigen::Ref<Points> gradient);

/// The constant Hessian 2 k_b L^T L, the same for x, y and z: n x n.
Eigen::SparseMatrix<double> bending_energy_hessian(double k_b, const Umbrella& umbrella);

}  // namespace vasorod
