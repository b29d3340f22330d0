// A Cholesky factor kept between solves: only what changed in the matrix is recomputed.
#pragma once

#include "numerics/cholesky.h"

namespace vasorod {

/// A Cholesky factor that is reused as long as its matrix does not change.
class KeptFactor {
 public:
  /// `work`: as that of Cholesky.
  explicit KeptFactor(Work* work = nullptr) : work_(work), cholesky_(work) {}

  /// Factorises a symmetric matrix, given by both triangles or by the lower one. An unchanged
  /// matrix costs only a comparison; an unchanged pattern needs no new analysis. Returns false when
  /// the matrix is not positive definite. `stop` and `precision`: as those of
  /// Cholesky::factorise(); one factor is kept with the same precision throughout.
  bool factorise(const Eigen::SparseMatrix<double>& matrix, const StopInside& stop = {},
                 Precision precision = Precision::exact);

  /// x = A^-1 b for `columns` right-hand sides, stored column-major.
  void solve(const double* b, double* x, int columns) { cholesky_.solve(b, x, columns); }

  /// The same for use as a preconditioner (Cholesky::precondition()).
  void precondition(const double* b, double* x, int columns) {
    cholesky_.precondition(b, x, columns);
  }

  int factorisations() const { return factorisations_; }  ///< since construction

 private:
  Work* work_;
  Cholesky cholesky_;
  Eigen::SparseMatrix<double> matrix_;
  int factorisations_ = 0;
};

}  // namespace vasorod
