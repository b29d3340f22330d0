// A supernodal Cholesky factor copied to single precision, for preconditioners. A solve is limited
// by memory bandwidth, and single precision halves the data it reads.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

struct cholmod_factor_struct;

namespace vasorod {

/// A single-precision copy of a supernodal Cholesky factor.
class SingleFactor {
 public:
  /// Copies a factorised supernodal L L^T.
  explicit SingleFactor(const cholmod_factor_struct& factor);

  /// x = A^-1 b for `columns` right-hand sides, stored column-major. In exact arithmetic the
  /// operator is symmetric positive definite.
  void solve(const double* b, double* x, int columns);

 private:
  struct Supernode;
  Supernode supernode(std::size_t k) const;

  std::vector<int> first_;           // per supernode, plus an end entry: first column
  std::vector<std::ptrdiff_t> row_;  // per supernode, plus an end entry: first row index
  // Per supernode: position of its first entry; columns are stored consecutively.
  std::vector<std::ptrdiff_t> entry_;
  std::vector<int> rows_, order_;
  std::vector<float> entries_;  // diagonal entries are stored inverted
  Eigen::MatrixXf values_, below_;
};

}  // namespace vasorod
