// Elastic binding of the surface to the rod [7]: E = k_c sum_i |p_i - p'_i|^2, p' where the rod's
// sections carry the vertices. k_c in force / length.
#pragma once

#include <Eigen/SparseCore>

#include <vasorod/types.h>

namespace vasorod {

double binding_energy(double k_c, const Eigen::Ref<const Points>& p,
                      const Eigen::Ref<const Points>& carried);

/// gradient += dE/dp; returns the energy.
double binding_energy_gradient(double k_c, const Eigen::Ref<const Points>& p,
                               const Eigen::Ref<const Points>& carried,
                               Eigen::Ref<Points> gradient);

/// The constant Hessian, the same for x, y and z: n x n.
Eigen::SparseMatrix<double> binding_energy_hessian(double k_c, int vertex_count);

}  // namespace vasorod
