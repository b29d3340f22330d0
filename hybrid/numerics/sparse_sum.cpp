#include "numerics/sparse_sum.h"

namespace vasorod {
namespace {

using Matrix = Eigen::SparseMatrix<double>;

// `take(row, value)` for each entry of a column of a + b.
template <class Take>
void for_sum(const Matrix& a, const Matrix& b, int column, Take take) {
  Matrix::InnerIterator left(a, column), right(b, column);
  while (left || right) {
    if (!right || (left && left.row() < right.row())) {
      take(left.row(), left.value());
      ++left;
    } else if (!left || right.row() < left.row()) {
      take(right.row(), right.value());
      ++right;
    } else {
      take(left.row(), left.value() + right.value());
      ++left;
      ++right;
    }
  }
}

}  // namespace

Matrix sparse_sum(const Matrix& a, const Matrix& b) {
  Matrix sum(a.rows(), a.cols());
  int entries = 0;
  for (int column = 0; column < a.cols(); ++column)
    for_sum(a, b, column, [&](Eigen::Index, double) { ++entries; });
  sum.resizeNonZeros(entries);
  int next = 0;
  for (int column = 0; column < a.cols(); ++column) {
    sum.outerIndexPtr()[column] = next;
    for_sum(a, b, column, [&](Eigen::Index row, double value) {
      sum.innerIndexPtr()[next] = static_cast<int>(row);
      sum.valuePtr()[next++] = value;
    });
  }
  sum.outerIndexPtr()[a.cols()] = next;
  return sum;
}

}  // namespace vasorod
