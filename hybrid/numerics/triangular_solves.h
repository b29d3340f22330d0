// Solves with a supernodal Cholesky factor, in double or single precision. Right-hand sides go up
// the elimination tree and solutions come down; independent subtrees are on different threads, as
// are pieces of the supernodes above them. Memory bandwidth limits them.
#pragma once

#include <vector>

#include "numerics/supernodes.h"

namespace vasorod {

/// Solves with factors of one pattern; its workspace is kept between solves.
template <class Scalar>
class TriangularSolves {
 public:
  /// x = A^-1 b for `count` right-hand sides, stored column-major; x may be b. `factor`: A's, as
  /// Fronts::factorise() fills it, in either precision. The numbers do not depend on `threads`.
  void solve(const Supernodes& nodes, const Scalar* factor, const double* b, double* x, int count,
             int threads);

 private:
  void up(const Supernodes& nodes, int k, const Scalar* factor, int count, int threads);
  void down(const Supernodes& nodes, int k, const Scalar* factor, int count, int threads,
            std::vector<Scalar>& below);

  // Right-hand sides, then solutions, in the order of elimination; and what each supernode passes
  // to its parent, of each right-hand side the rows below its columns.
  std::vector<Scalar> values_, passed_;
};

extern template class TriangularSolves<double>;
extern template class TriangularSolves<float>;

}  // namespace vasorod
