// Sparse Cholesky factorisation of a symmetric positive definite matrix: CHOLMOD's supernodal L L^T
// behind a small wrapper. The analysis is kept while the pattern stays, workspaces are kept between
// solves.
#pragma once

#include <Eigen/SparseCore>
#include <memory>
#include <vector>

namespace vasorod {

/// An elimination order of a symmetric matrix' unknowns, found on the graph of its groups: the
/// first unknown of each group, ascending from 0; a group's unknowns share their rows outside it.
/// Nested dissection (METIS) costs ten times what minimum degree (AMD) does and gives shells half
/// its flops: worth it from the second factorisation on.
enum class Ordering { minimum_degree, nested_dissection };
std::vector<int> elimination_order(const Eigen::SparseMatrix<double>& matrix,
                                   const std::vector<int>& groups, Ordering ordering);

class Cholesky {
 public:
  Cholesky();
  ~Cholesky();
  Cholesky(Cholesky&&) noexcept;
  Cholesky& operator=(Cholesky&&) noexcept;

  /// Orders (AMD) and analyses the pattern of a symmetric matrix; the lower triangle is read. With
  /// block = 3 the unknowns 3i, 3i+1, 3i+2 share one pattern row, and the ordering is found on the
  /// graph of the blocks.
  void analyse(const Eigen::SparseMatrix<double>& matrix, int block = 1);

  /// The same with an elimination order that is known already (see elimination_order).
  void analyse(const Eigen::SparseMatrix<double>& matrix, const std::vector<int>& order);

  /// Factorises a matrix of the analysed pattern. False when it is not positive definite (then
  /// nothing can be solved).
  bool factorise(const Eigen::SparseMatrix<double>& matrix);

  /// x = A^-1 b for `columns` right-hand sides, column-major.
  void solve(const double* b, double* x, int columns);

  /// The same as a preconditioner: in single precision (single_factor.h), as long as the first
  /// solve with a new factor shows that it differs by less than a thousandth.
  void precondition(const double* b, double* x, int columns);

  bool analysed() const;
  bool factorised() const;
  /// Entries of the factor.
  double factor_nonzeros() const;

 private:
  friend std::vector<int> elimination_order(const Eigen::SparseMatrix<double>&,
                                            const std::vector<int>&, Ordering);
  struct Data;
  std::unique_ptr<Data> data_;
};

}  // namespace vasorod
