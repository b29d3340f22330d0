#include "numerics/kept_factor.h"

#include <algorithm>
#include <numeric>
#include <vector>

#include "numerics/within_pattern.h"

namespace vasorod {
namespace {

// From this number of unknowns on, nested dissection pays off within one solve.
constexpr int large = 200000;

}  // namespace

bool KeptFactor::factorise(const Eigen::SparseMatrix<double>& matrix, const StopInside& stop) {
  const bool analysed = cholesky_.analysed() && same_pattern(matrix, matrix_);
  if (analysed && cholesky_.factorised() &&
      std::equal(matrix.valuePtr(), matrix.valuePtr() + matrix.nonZeros(), matrix_.valuePtr()))
    return true;
  if (!analysed && matrix.cols() > large) {
    std::vector<int> each(static_cast<size_t>(matrix.cols()));
    std::iota(each.begin(), each.end(), 0);
    cholesky_.analyse(matrix, elimination_order(matrix, each, Ordering::nested_dissection, work_));
  } else if (!analysed) {
    cholesky_.analyse(matrix);
  }
  matrix_ = matrix;
  ++factorisations_;
  return cholesky_.factorise(matrix_, stop, precision_);
}

}  // namespace vasorod
