// Elastic binding of the surface to the rod [7]:
//
//   E = k_c sum_i |p_i - p'_i|^2
//
// p'_i is the position of vertex i after the rigid motion of its section. k_c in force / length.
#pragma once

#include <Eigen/SparseCore>

#include <vasorod/types.h>

namespace vasorod {

/// Energy, force * length. `p`: n x 3; `carried`: p', n x 3.
double binding_energy(double k_c, const Eigen::Ref<const Points>& p,
                      const Eigen::Ref<const Points>& carried);

/// gradient += dE/dp (n x 3); returns the energy.
double binding_energy_gradient(double k_c, const Eigen::Ref<const Points>& p,
                               const Eigen::Ref<const Points>& carried,
                               Eigen::Ref<Points> gradient);

/// The constant Hessian, the same for x, y and z: n x n.
Eigen::SparseMatrix<double> binding_energy_hessian(double k_c, int vertex_count);

}  // namespace vasorod
