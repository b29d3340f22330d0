// Sparse Cholesky factorisation of a symmetric positive definite matrix: CHOLMOD's supernodal
// analysis, and its numbers on the threads of threads.h. The analysis is kept while the pattern
// stays the same, and workspaces are kept between solves. All of it throws std::bad_alloc where the
// memory does not suffice.
#pragma once

#include <Eigen/SparseCore>
#include <memory>
#include <vector>

#include "numerics/analysis.h"
#include "numerics/stop_inside.h"
#include "numerics/work.h"

namespace vasorod {

/// `exact`: in double precision. `rough`: for directions of search, in single precision, which
/// takes about half the time, unless the first such factor is found not to be good enough: where
/// one step of iterative refinement changes a solve by a hundredth, that one and all later ones
/// are exact.
enum class Precision { exact, rough };

/// A sparse Cholesky factor: analyse() once per pattern, factorise() per matrix, then solve().
class Cholesky {
 public:
  /// Factorisations, solves and their time are added to `work`, which must outlive this; null: they
  /// are not counted.
  explicit Cholesky(Work* work = nullptr);
  ~Cholesky();
  Cholesky(Cholesky&&) noexcept;
  Cholesky& operator=(Cholesky&&) noexcept;

  /// Orders (AMD) and analyses the pattern of a symmetric matrix; only the lower triangle is read.
  /// With block = 3 the unknowns 3i, 3i+1, 3i+2 share one pattern row, and the ordering is found on
  /// the graph of the blocks.
  void analyse(const Eigen::SparseMatrix<double>& matrix, int block = 1);

  /// The same with a known elimination order (see elimination_order()).
  void analyse(const Eigen::SparseMatrix<double>& matrix, const std::vector<int>& order);

  /// Factorises a matrix with the analysed pattern. Returns false when the matrix is not positive
  /// definite; solve() must not be called then. The first failure in single precision is repeated
  /// exactly. If that succeeds, no later factor is rough; if it fails as well, further ones are
  /// believed until an exact factor succeeds. `stop` is asked on the way; where it says so,
  /// Interruption is thrown, and there is no factor.
  bool factorise(const Eigen::SparseMatrix<double>& matrix, const StopInside& stop = {},
                 Precision precision = Precision::exact);

  /// Whether a matrix with the analysed pattern is positive definite, as an exact factor finds it,
  /// of which no numbers are kept: it needs little memory. The factor of another matrix remains.
  bool is_positive_definite(const Eigen::SparseMatrix<double>& matrix, const StopInside& stop = {});

  /// x = A^-1 b for `columns` right-hand sides, stored column-major; with the digits of a rough
  /// factor where the last one is.
  void solve(const double* b, double* x, int columns);

  /// The same for use as a preconditioner: in single precision, which halves the data it reads,
  /// provided that the first solve with a new factor differs from the double-precision solve by
  /// less than a thousandth.
  void precondition(const double* b, double* x, int columns);

  bool analysed() const;
  bool factorised() const;
  /// Number of entries of the factor.
  double factor_nonzeros() const;

 private:
  void copy_to_single();
  bool single_will_do(const Eigen::SparseMatrix<double>& matrix);

  struct Data;
  std::unique_ptr<Data> data_;
};

}  // namespace vasorod
