// Sparse direct solvers. One process: supernodal Cholesky (CHOLMOD) if the matrix is symmetric
// positive definite, UMFPACK otherwise. Several processes: MUMPS through PETSc, L D L^T or LU
// (distributed_solver.h).
#pragma once

#include <Eigen/SparseCore>
#include <memory>

#include "reference_fem/processes.h"

namespace vasorod::fem {

using Sparse = Eigen::SparseMatrix<double>;

/// Factorises and solves on one process or on several.
class LinearSolver {
 public:
  enum class Fallback { umfpack, none };

  explicit LinearSolver(const Processes& processes = {});
  ~LinearSolver();
  LinearSolver(const LinearSolver&) = delete;
  LinearSolver& operator=(const LinearSolver&) = delete;

  /// Factorises. The pattern must be the same in every call. False: the matrix is singular. The
  /// last `multipliers` unknowns are those of constraints (zero diagonal block). With several
  /// processes, the matrix is the sum of the processes' matrices.
  bool factor(const Sparse& matrix, bool symmetric, int multipliers = 0,
              Fallback fallback = Fallback::umfpack);
  /// Whether the last factor() found the matrix positive definite on its constraints. Always false
  /// for matrices that are not symmetric.
  bool positive_definite() const;
  /// `right` and the solution are complete on every process.
  Eigen::VectorXd solve(const Eigen::VectorXd& right) const;
  /// Entries of the last factor; of L and U where the matrix was not positive definite.
  double factor_nonzeros() const;

  /// One implementation.
  class Method {
   public:
    virtual ~Method() = default;
    virtual bool factor(const Sparse& matrix, bool symmetric, int multipliers,
                        Fallback fallback) = 0;
    virtual bool positive_definite() const = 0;
    virtual Eigen::VectorXd solve(const Eigen::VectorXd& right) const = 0;
    virtual double factor_nonzeros() const = 0;
  };

 private:
  std::unique_ptr<Method> method_;
};

}  // namespace vasorod::fem
