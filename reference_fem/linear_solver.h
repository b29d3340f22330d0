// Sparse direct solves: supernodal Cholesky (CHOLMOD) while the matrix is symmetric positive definite,
// UMFPACK otherwise.
#pragma once

#include <Eigen/SparseCore>
#include <memory>

namespace vasorod::fem {

using Sparse = Eigen::SparseMatrix<double>;

class LinearSolver {
 public:
  LinearSolver();
  ~LinearSolver();
  LinearSolver(const LinearSolver&) = delete;
  LinearSolver& operator=(const LinearSolver&) = delete;

  /// Factorises; the pattern must stay the same from call to call. False when the matrix is singular. The
  /// last `multipliers` unknowns are those of constraints (zero diagonal block): a symmetric matrix is then
  /// tried as K + gamma B B^T, which is positive definite where K is so on the constraints, and the
  /// multipliers follow from their Schur complement.
  enum class Fallback { umfpack, none };
  bool factor(const Sparse& matrix, bool symmetric, int multipliers = 0,
              Fallback fallback = Fallback::umfpack);
  /// Whether the last factor() found the matrix positive definite on its constraints (only symmetric matrices
  /// are tried).
  bool positive_definite() const;
  Eigen::VectorXd solve(const Eigen::VectorXd& right) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace vasorod::fem
