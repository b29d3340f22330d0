// Sparse direct solves. One process: supernodal Cholesky (CHOLMOD) while the matrix is symmetric
// positive definite, UMFPACK otherwise. Several: MUMPS through PETSc, L D L^T or LU
// (distributed_solver.h).
#pragma once

#include <Eigen/SparseCore>
#include <memory>

#include "reference_fem/processes.h"

namespace vasorod::fem {

using Sparse = Eigen::SparseMatrix<double>;

class LinearSolver {
 public:
  enum class Fallback { umfpack, none };

  explicit LinearSolver(const Processes& processes = {});
  ~LinearSolver();
  LinearSolver(const LinearSolver&) = delete;
  LinearSolver& operator=(const LinearSolver&) = delete;

  /// Factorises; the pattern must stay the same from call to call. False when the matrix is
  /// singular. The last `multipliers` unknowns are those of constraints (zero diagonal block). With
  /// several processes the matrix is the sum of what they give.
  bool factor(const Sparse& matrix, bool symmetric, int multipliers = 0,
              Fallback fallback = Fallback::umfpack);
  /// Whether the last factor() found the matrix positive definite on its constraints (only
  /// symmetric matrices are tried).
  bool positive_definite() const;
  /// `right` and the solution are whole on every process.
  Eigen::VectorXd solve(const Eigen::VectorXd& right) const;

  /// One way to do so.
  class Method {
   public:
    virtual ~Method() = default;
    virtual bool factor(const Sparse& matrix, bool symmetric, int multipliers,
                        Fallback fallback) = 0;
    virtual bool positive_definite() const = 0;
    virtual Eigen::VectorXd solve(const Eigen::VectorXd& right) const = 0;
  };

 private:
  std::unique_ptr<Method> method_;
};

}  // namespace vasorod::fem
