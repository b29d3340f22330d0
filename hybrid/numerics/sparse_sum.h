// The sum of two sparse matrices with different patterns.
#pragma once

#include <Eigen/SparseCore>

namespace vasorod {

/// a + b, with an entry where one of them has one; both compressed, of one size. The same as
/// Eigen's own sum, whose memory grows, and is copied, while it is filled.
Eigen::SparseMatrix<double> sparse_sum(const Eigen::SparseMatrix<double>& a,
                                       const Eigen::SparseMatrix<double>& b);

}  // namespace vasorod
