// What a sparse Cholesky factorisation knows of the pattern alone, by CHOLMOD: the order of
// elimination and the supernodes. All of it throws std::bad_alloc where the memory does not
// suffice.
#pragma once

#include <Eigen/SparseCore>
#include <memory>
#include <vector>

#include "numerics/supernodes.h"
#include "numerics/work.h"

struct cholmod_sparse_struct;

namespace vasorod {

/// An elimination order for the unknowns of a symmetric matrix, found on the graph of its groups.
/// `groups` lists the first unknown of each group, ascending from 0; all unknowns of a group must
/// have the same rows outside the group.
///
/// Nested dissection (METIS) costs ten times as much as minimum degree (AMD) and halves the flops
/// of the factorisation for shells. It pays off from the second factorisation on. `cheaper`: for a
/// few factorisations; minimum degree where the graph is small and that order's work little, else
/// nested dissection. The time is added to `work`, which may be null.
enum class Ordering { minimum_degree, nested_dissection, cheaper };
std::vector<int> elimination_order(const Eigen::SparseMatrix<double>& matrix,
                                   const std::vector<int>& groups, Ordering ordering,
                                   Work* work = nullptr);

/// The symbolic factor of one pattern.
class Analysis {
 public:
  /// Of a symmetric matrix, of which only the lower triangle is read. `order`: its elimination
  /// order; empty: minimum degree (AMD).
  Analysis(const Eigen::SparseMatrix<double>& matrix, const std::vector<int>& order);
  ~Analysis();

  const Supernodes& nodes() const;
  double factor_nonzeros() const;  ///< number of entries of the factor

  /// The lower triangle of a matrix of the pattern in the order of elimination, the rows of each
  /// column in any order; it lives until the next call.
  const cholmod_sparse_struct& in_order(const Eigen::SparseMatrix<double>& matrix);

 private:
  void sort_places(const Eigen::SparseMatrix<double>& matrix);

  struct Data;
  std::unique_ptr<Data> data_;
};

}  // namespace vasorod
