#include "reference_fem/linear_solver.h"

#include <Eigen/CholmodSupport>
#include <Eigen/Dense>
#include <Eigen/UmfPackSupport>

#include "numerics/blas.h"
#include "reference_fem/distributed_solver.h"

namespace vasorod::fem {
namespace {

/// UMFPACK, which states the entries of its factors.
class Lu : public Eigen::UmfPackLU<Sparse> {
 public:
  using Eigen::UmfPackLU<Sparse>::UmfPackLU;
  double factor_nonzeros() const { return m_umfpackInfo[UMFPACK_LNZ] + m_umfpackInfo[UMFPACK_UNZ]; }
};

/// CHOLMOD and UMFPACK. A symmetric matrix with constraints is factorised as K + gamma B B^T, which
/// is positive definite if K is positive definite on the constraints. The multipliers follow from
/// their Schur complement.
class OneProcess final : public LinearSolver::Method {
 public:
  OneProcess() { cholesky.cholmod().print = 0; }

  bool factor(const Sparse& whole, bool symmetric, int multipliers,
              LinearSolver::Fallback fallback) override {
    const OneCholmodThread one_thread;
    definite = false;
    constraints.resize(0, 0);
    if (symmetric && multipliers > 0) {
      definite = factor_constrained(whole, multipliers);
    } else if (symmetric) {
      if (!analysed) cholesky.analyzePattern(whole);
      analysed = true;
      cholesky.factorize(whole);
      definite = cholesky.info() == Eigen::Success;
    }
    if (definite || fallback == LinearSolver::Fallback::none) return definite;
    matrix = whole;
    lu = std::make_unique<Lu>(matrix);
    return lu->info() == Eigen::Success;
  }

  bool positive_definite() const override { return definite; }

  Eigen::VectorXd solve(const Eigen::VectorXd& right) const override {
    const OneCholmodThread one_thread;
    if (!definite) return lu->solve(right);
    return constraints.cols() > 0 ? solve_constrained(right)
                                  : Eigen::VectorXd(cholesky.solve(right));
  }

  double factor_nonzeros() const override {
    return definite ? cholesky.cholmod().lnz : lu ? lu->factor_nonzeros() : 0;
  }

 private:
  bool factor_constrained(const Sparse& whole, int multipliers) {
    const Eigen::Index n = whole.cols() - multipliers;
    const Sparse K = whole.topLeftCorner(n, n);
    constraints = whole.topRightCorner(n, multipliers);
    // Springs in place of constraints buckle at a lower load: with 10 in place of 1e5, a column on
    // a soft root is called unstable below its buckling load. A larger factor would cost accuracy.
    gamma = 1e5 * K.diagonal().mean() * multipliers / constraints.squaredNorm();
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
    const Eigen::VectorXd x =
        cholesky.solve(Eigen::VectorXd(right.head(n) + gamma * (constraints * g)));
    Eigen::VectorXd out(n + m);
    out.tail(m) = schur.solve(constraints.transpose() * x - g);
    out.head(n) = x - spread * out.tail(m);
    return out;
  }

  mutable Eigen::CholmodSupernodalLLT<Sparse, Eigen::Lower> cholesky;  // cholmod() is not const
  std::unique_ptr<Lu> lu;
  Sparse matrix;  // UMFPACK solves refer to it
  Sparse constraints;
  Eigen::MatrixXd spread;  // K'^-1 B
  Eigen::PartialPivLU<Eigen::MatrixXd> schur;
  double gamma = 0;
  bool analysed = false, definite = false;
};

}  // namespace

LinearSolver::LinearSolver(const Processes& processes)
    : method_(processes.size() > 1 ? distributed_method(processes)
                                   : std::make_unique<OneProcess>()) {}
LinearSolver::~LinearSolver() = default;

bool LinearSolver::factor(const Sparse& matrix, bool symmetric, int multipliers,
                          Fallback fallback) {
  return method_->factor(matrix, symmetric, multipliers, fallback);
}

bool LinearSolver::positive_definite() const {
  return method_->positive_definite();
}

Eigen::VectorXd LinearSolver::solve(const Eigen::VectorXd& right) const {
  return method_->solve(right);
}

double LinearSolver::factor_nonzeros() const {
  return method_->factor_nonzeros();
}

}  // namespace vasorod::fem
