// The numbers of a supernodal Cholesky factor, computed front by front (Duff and Reid 1983; Liu,
// The multifrontal method, SIAM Review 34, 1992): the columns of a supernode and what they change
// in later columns are one dense matrix, its front, to which the fronts of the children add what
// they changed. Independent subtrees are on different threads, and so are panels of the large
// fronts above them. CHOLMOD 3.0 computes the same from left to right on one thread; no library of
// Debian 12 shares the tree between threads.
#pragma once

#include <memory>
#include <vector>

#include "numerics/stop_inside.h"
#include "numerics/supernodes.h"

struct cholmod_sparse_struct;

namespace vasorod {

/// Factorises matrices of one pattern, in double or single precision. It does not move: it keeps a
/// reference to `nodes`.
template <class Scalar>
class Fronts {
 public:
  explicit Fronts(const Supernodes& nodes) : nodes_(nodes), changes_(index(nodes.size())) {}

  /// Fills `factor`, nodes.entries() numbers, from the lower triangle of a matrix in the order of
  /// elimination; null: its columns are forgotten as soon as they are not needed any more. Returns
  /// false where the matrix is not positive definite; the factor is incomplete then. The numbers do
  /// not depend on `threads`. `stop` is asked between fronts, from the calling thread, each time
  /// they took some million operations. Throws Interruption where it says so, and std::bad_alloc.
  bool factorise(const cholmod_sparse_struct& matrix, Scalar* factor, int threads,
                 const StopInside& stop = {});

 private:
  // Of one thread, per row of the matrix: its place in the front at hand.
  using Places = std::vector<int>;
  // What one thread works with.
  struct Workspace {
    Places places;
    std::vector<Scalar> columns;  // of the front at hand, where they are not kept
  };

  bool eliminate(int k, const cholmod_sparse_struct& matrix, Scalar* factor, Workspace& workspace,
                 int threads);
  Scalar* columns_of(int k, Scalar* factor, Workspace& workspace) const;
  void set_own(int k, const cholmod_sparse_struct& matrix, const Places& places, int first, int end,
               Scalar* columns) const;
  void add_below(int k, int first, int end, Scalar* change) const;

  const Supernodes& nodes_;
  // Per supernode, from its elimination to that of its parent: what it changes in later columns,
  // the lower triangle of a square, column-major.
  std::vector<std::unique_ptr<Scalar[]>> changes_;
};

extern template class Fronts<double>;
extern template class Fronts<float>;

}  // namespace vasorod
