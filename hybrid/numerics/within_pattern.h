// Sparse matrices whose pattern lies within another's, in one pass and without a new pattern.
#pragma once

#include <Eigen/SparseCore>

namespace vasorod {

/// sum = a + factor * b. `sum` has the pattern of a, which contains that of b.
void add_within(const Eigen::SparseMatrix<double>& a, double factor,
                const Eigen::SparseMatrix<double>& b, Eigen::SparseMatrix<double>& sum);

/// Whether both have entries at the same places; both compressed.
bool same_pattern(const Eigen::SparseMatrix<double>& a, const Eigen::SparseMatrix<double>& b);

/// Gives the matrix the pattern, with zeros where it has no entries. Returns false and changes
/// nothing where it has entries that the pattern lacks.
bool pad(const Eigen::SparseMatrix<double>& pattern, Eigen::SparseMatrix<double>& matrix);

}  // namespace vasorod
