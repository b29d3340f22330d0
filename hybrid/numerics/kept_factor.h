// A Cholesky factor that outlives one solve: it is renewed only as far as its matrix has changed.
#pragma once

#include "numerics/cholesky.h"

namespace vasorod {

class KeptFactor {
 public:
  /// Symmetric, both triangles or the lower one. The same matrix again costs a comparison, the same
  /// pattern no analysis. False when it is not positive definite.
  bool factorise(const Eigen::SparseMatrix<double>& matrix);

  /// x = A^-1 b for `columns` right-hand sides, column-major.
  void solve(const double* b, double* x, int columns) { cholesky_.solve(b, x, columns); }

  /// The same as a preconditioner (Cholesky::precondition).
  void precondition(const double* b, double* x, int columns) {
    cholesky_.precondition(b, x, columns);
  }

  int factorisations() const { return factorisations_; }  ///< since construction

 private:
  Cholesky cholesky_;
  Eigen::SparseMatrix<double> matrix_;
  int factorisations_ = 0;
};

}  // namespace vasorod
