// A supernodal Cholesky factor copied into single precision, for preconditioners: a solve waits for
// memory, and this reads half of it.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

struct cholmod_factor_struct;

namespace vasorod {

class SingleFactor {
 public:
  /// Of a factorised supernodal L L^T.
  explicit SingleFactor(const cholmod_factor_struct& factor);

  /// x = A^-1 b for `columns` right-hand sides, column-major; in exact arithmetic symmetric and
  /// positive.
  void solve(const double* b, double* x, int columns);

 private:
  struct Supernode;
  Supernode supernode(std::size_t k) const;

  std::vector<int> first_;           // per supernode and one past them: its first column
  std::vector<std::ptrdiff_t> row_;  // per supernode and one past them: where its rows start
  std::vector<std::ptrdiff_t>
      entry_;  // per supernode: where its columns start, one after the other
  std::vector<int> rows_, order_;
  std::vector<float> entries_;  // on the diagonal the inverse
  Eigen::MatrixXf values_, below_;
};

}  // namespace vasorod
