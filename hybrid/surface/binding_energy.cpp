#include "surface/binding_energy.h"

namespace vasorod {

double binding_energy(double k_c, const Eigen::Ref<const Points>& p,
                      const Eigen::Ref<const Points>& carried) {
  return k_c * (p - carried).squaredNorm();
}

void binding_energy_gradient(double k_c, const Eigen::Ref<const Points>& p,
                             const Eigen::Ref<const Points>& carried, Eigen::Ref<Points> gradient) {
  gradient += 2 * k_c * (p - carried);
}

Eigen::SparseMatrix<double> binding_energy_hessian(double k_c, int vertex_count) {
  Eigen::SparseMatrix<double> hessian(vertex_count, vertex_count);
  hessian.setIdentity();
  hessian *= 2 * k_c;
  return hessian;
}

}  // namespace vasorod
