#include "reference_fem/linear_solver.h"

#include <Eigen/CholmodSupport>
#include <Eigen/UmfPackSupport>

namespace vasorod::fem {

struct LinearSolver::Impl {
  Eigen::CholmodSupernodalLLT<Sparse, Eigen::Lower> cholesky;
  std::unique_ptr<Eigen::UmfPackLU<Sparse>> lu;
  Sparse matrix;  // UMFPACK solves refer to it
  bool analysed = false, definite = false;
};

LinearSolver::LinearSolver() : impl_(std::make_unique<Impl>()) {
  impl_->cholesky.cholmod().print = 0;
}
LinearSolver::~LinearSolver() = default;

bool LinearSolver::factor(const Sparse& matrix, bool symmetric) {
  impl_->definite = false;
  if (symmetric) {
    if (!impl_->analysed) impl_->cholesky.analyzePattern(matrix);
    impl_->analysed = true;
    impl_->cholesky.factorize(matrix);
    impl_->definite = impl_->cholesky.info() == Eigen::Success;
    if (impl_->definite) return true;
  }
  impl_->matrix = matrix;
  impl_->lu = std::make_unique<Eigen::UmfPackLU<Sparse>>(impl_->matrix);
  return impl_->lu->info() == Eigen::Success;
}

bool LinearSolver::positive_definite() const {
  return impl_->definite;
}

Eigen::VectorXd LinearSolver::solve(const Eigen::VectorXd& right) const {
  return impl_->definite ? Eigen::VectorXd(impl_->cholesky.solve(right))
                         : Eigen::VectorXd(impl_->lu->solve(right));
}

}  // namespace vasorod::fem
