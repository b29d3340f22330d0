#include "paper/bending_energy.h"

namespace vasorod {

Points carried_laplacian(const Umbrella& umbrella, const Eigen::Ref<const Points>& rest,
                         const std::vector<Mat3>& rotations) {
  Points l = umbrella.apply(rest);
  for (int i = 0; i < l.rows(); ++i)
    l.row(i) = (rotations[static_cast<size_t>(i)] * l.row(i).transpose()).transpose();
  return l;
}

double bending_energy(double k_b, const Umbrella& umbrella, const Eigen::Ref<const Points>& p,
                      const Eigen::Ref<const Points>& carried) {
  return k_b * (umbrella.apply(p) - carried).squaredNorm();
}

double bending_energy_gradient(double k_b, const Umbrella& umbrella,
                               const Eigen::Ref<const Points>& p,
                               const Eigen::Ref<const Points>& carried,
                               Eigen::Ref<Points> gradient) {
  return k_b * umbrella.add_misfit(p, carried, 2 * k_b, gradient);
}

Eigen::SparseMatrix<double> bending_energy_hessian(double k_b, const Umbrella& umbrella) {
  const Eigen::SparseMatrix<double> l = umbrella.matrix();
  return 2 * k_b * Eigen::SparseMatrix<double>(l.transpose() * l);
}

}  // namespace vasorod
