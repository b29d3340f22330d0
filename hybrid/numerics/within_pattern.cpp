#include "numerics/within_pattern.h"

#include <algorithm>
#include <vector>

namespace vasorod {

using Matrix = Eigen::SparseMatrix<double>;

void add_within(const Matrix& a, double factor, const Matrix& b, Matrix& sum) {
  for (int column = 0; column < a.cols(); ++column) {
    const int* row = a.innerIndexPtr();
    int at = a.outerIndexPtr()[column];
    const int end = a.outerIndexPtr()[column + 1];
    for (Matrix::InnerIterator it(b, column); it; ++it) {
      for (; row[at] != it.row(); ++at) sum.valuePtr()[at] = a.valuePtr()[at];
      sum.valuePtr()[at] = a.valuePtr()[at] + factor * it.value();
      ++at;
    }
    for (; at < end; ++at) sum.valuePtr()[at] = a.valuePtr()[at];
  }
}

bool same_pattern(const Matrix& a, const Matrix& b) {
  return a.rows() == b.rows() && a.cols() == b.cols() && a.nonZeros() == b.nonZeros() &&
         std::equal(a.outerIndexPtr(), a.outerIndexPtr() + a.outerSize() + 1, b.outerIndexPtr()) &&
         std::equal(a.innerIndexPtr(), a.innerIndexPtr() + a.nonZeros(), b.innerIndexPtr());
}

bool pad(const Matrix& pattern, Matrix& matrix) {
  if (pattern.cols() != matrix.cols()) return false;
  if (same_pattern(pattern, matrix)) return true;
  std::vector<double> values(static_cast<size_t>(pattern.nonZeros()), 0.0);
  const int* row = pattern.innerIndexPtr();
  for (int column = 0; column < matrix.cols(); ++column) {
    int at = pattern.outerIndexPtr()[column];
    const int end = pattern.outerIndexPtr()[column + 1];
    for (Matrix::InnerIterator it(matrix, column); it; ++it, ++at) {
      while (at < end && row[at] < it.row()) ++at;
      if (at == end || row[at] != it.row()) return false;
      values[static_cast<size_t>(at)] = it.value();
    }
  }
  matrix = pattern;
  std::copy(values.begin(), values.end(), matrix.valuePtr());
  return true;
}

}  // namespace vasorod
