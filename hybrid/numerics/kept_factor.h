// A Cholesky factor kept between solves: only what changed in the matrix is recomputed.
#pragma once

#include "numerics/cholesky.h"

namespace vasorod {

/// A Cholesky factor that is reused as long as its matrix does not change.
class KeptFactor {
 public:
  /// `work`: as that of Cholesky. `precision`: of all factors.
  explicit KeptFactor(Work* work = nullptr, Precision precision = Precision::exact)
      : work_(work), precision_(precision), cholesky_(work) {}

  /// Factorises a symmetric matrix, given by both triangles or by the lower one. An unchanged
  /// matrix costs only a comparison; an unchanged pattern needs no new analysis. Returns false when
  /// the matrix is not positive definite. `stop`: as that of Cholesky::factorise().
  bool factorise(const Eigen::SparseMatrix<double>& matrix, const StopInside& stop = {});

  /// x = A^-1 b for `columns` right-hand sides, stored column-major.
  void solve(const double* b, double* x, int columns) { cholesky_.solve(b, x, columns); }

  /// The same for use as a preconditioner (Cholesky::precondition()).
  void precondition(const double* b, double* x, int columns) {
    cholesky_.precondition(b, x, columns);
  }

  int factorisations() const { return factorisations_; }  ///< since construction

 private:
  Work* work_;
  Precision precision_;
  Cholesky cholesky_;
  Eigen::SparseMatrix<double> matrix_;
  int factorisations_ = 0;
};

}  // namespace vasorod
