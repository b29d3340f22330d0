#include "reference_fem/linear_solver.h"

#include <Eigen/CholmodSupport>
#include <Eigen/Dense>
#include <Eigen/UmfPackSupport>

namespace vasorod::fem {

struct LinearSolver::Impl {
  Eigen::CholmodSupernodalLLT<Sparse, Eigen::Lower> cholesky;
  std::unique_ptr<Eigen::UmfPackLU<Sparse>> lu;
  Sparse matrix;  // UMFPACK solves refer to it
  Sparse constraints;
  Eigen::MatrixXd spread;  // K'^-1 B
  Eigen::PartialPivLU<Eigen::MatrixXd> schur;
  double gamma = 0;
  bool analysed = false, definite = false;

  bool factor_constrained(const Sparse& whole, int multipliers) {
    const Eigen::Index n = whole.cols() - multipliers;
    const Sparse K = whole.topLeftCorner(n, n);
    constraints = whole.topRightCorner(n, multipliers);
    // large enough to hold rigid motions, small enough not to spoil the condition
    gamma = 10 * K.diagonal().mean() * multipliers / constraints.squaredNorm();
    const Sparse held = K + gamma * Sparse(constraints * Sparse(constraints.transpose()));
    if (!analysed) cholesky.analyzePattern(held);
    analysed = true;
    cholesky.factorize(held);
    if (cholesky.info() != Eigen::Success) return false;
    spread = cholesky.solve(Eigen::MatrixXd(constraints));
    schur.compute(constraints.transpose() * spread);
    return spread.allFinite();
  }

  // K x + B l = f, B^T x = g  <=>  K' x + B l = f + gamma B g, B^T x = g
  Eigen::VectorXd solve_constrained(const Eigen::VectorXd& right) const {
    const Eigen::Index n = constraints.rows(), m = constraints.cols();
    const Eigen::VectorXd g = right.tail(m);
    const Eigen::VectorXd x = cholesky.solve(Eigen::VectorXd(right.head(n) + gamma * (constraints * g)));
    Eigen::VectorXd out(n + m);
    out.tail(m) = schur.solve(constraints.transpose() * x - g);
    out.head(n) = x - spread * out.tail(m);
    return out;
  }
};

LinearSolver::LinearSolver() : impl_(std::make_unique<Impl>()) {
  impl_->cholesky.cholmod().print = 0;
}
LinearSolver::~LinearSolver() = default;

bool LinearSolver::factor(const Sparse& matrix, bool symmetric, int multipliers, Fallback fallback) {
  impl_->definite = false;
  impl_->constraints.resize(0, 0);
  if (symmetric && multipliers > 0) {
    impl_->definite = impl_->factor_constrained(matrix, multipliers);
  } else if (symmetric) {
    if (!impl_->analysed) impl_->cholesky.analyzePattern(matrix);
    impl_->analysed = true;
    impl_->cholesky.factorize(matrix);
    impl_->definite = impl_->cholesky.info() == Eigen::Success;
  }
  if (impl_->definite || fallback == Fallback::none) return impl_->definite;
  impl_->matrix = matrix;
  impl_->lu = std::make_unique<Eigen::UmfPackLU<Sparse>>(impl_->matrix);
  return impl_->lu->info() == Eigen::Success;
}

bool LinearSolver::positive_definite() const {
  return impl_->definite;
}

Eigen::VectorXd LinearSolver::solve(const Eigen::VectorXd& right) const {
  if (!impl_->definite) return impl_->lu->solve(right);
  return impl_->constraints.cols() > 0 ? impl_->solve_constrained(right)
                                       : Eigen::VectorXd(impl_->cholesky.solve(right));
}

}  // namespace vasorod::fem
