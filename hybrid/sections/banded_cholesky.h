// Cholesky factorisation of a symmetric band matrix by LAPACK (dpbtrf).
#pragma once

#include <Eigen/Core>
#include <algorithm>

namespace vasorod {

/// The lower triangle of a symmetric matrix of `size` rows whose entries are zero beyond `width`
/// from the diagonal.
class BandMatrix {
 public:
  BandMatrix(int size, int width) : width_(width), band_(Eigen::MatrixXd::Zero(width + 1, size)) {}

  int size() const { return static_cast<int>(band_.cols()); }
  int width() const { return width_; }
  double& lower(int i, int j) { return band_(i - j, j); }
  /// Adds to the lower triangle what a block at (row, column) has of it.
  template <class Block>
  void add(int row, int column, const Block& block) {
    for (Eigen::Index j = 0; j < block.cols(); ++j)
      for (Eigen::Index i = std::max<Eigen::Index>(0, column + j - row); i < block.rows(); ++i)
        band_(row + i - column - j, column + j) += block(i, j);
  }
  Eigen::VectorXd diagonal() const { return band_.row(0).transpose(); }
  void add_to_diagonal(const Eigen::VectorXd& values) { band_.row(0) += values.transpose(); }

  /// Factorises in place; false if the matrix is not positive definite.
  bool factorise();
  /// Solves in place with the factor; the columns of x are right-hand sides.
  void solve(Eigen::Ref<Eigen::MatrixXd> x) const;

 private:
  int width_;
  Eigen::MatrixXd band_;  // LAPACK's lower band storage
};

}  // namespace vasorod
