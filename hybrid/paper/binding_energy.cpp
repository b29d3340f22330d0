#include "paper/binding_energy.h"

namespace vasorod {

double binding_energy(double k_c, const Eigen::Ref<const Points>& p,
                      const Eigen::Ref<const Points>& carried) {
  return k_c * (p - carried).squaredNorm();
}

double binding_energy_gradient(double k_c, const Eigen::Ref<const Points>& p,
                               const Eigen::Ref<const Points>& carried,
                               Eigen::Ref<Points> gradient) {
  double squares = 0;
  for (Eigen::Index i = 0; i < p.rows(); ++i) {
    const Eigen::RowVector3d misfit = p.row(i) - carried.row(i);
    gradient.row(i) += 2 * k_c * misfit;
    squares += misfit.squaredNorm();
  }
  return k_c * squares;
}

Eigen::SparseMatrix<double> binding_energy_hessian(double k_c, int vertex_count) {
  Eigen::SparseMatrix<double> hessian(vertex_count, vertex_count);
  hessian.setIdentity();
  hessian *= 2 * k_c;
  return hessian;
}

}  // namespace vasorod
