#include "sections/banded_cholesky.h"

extern "C" {
void dpbtrf_(const char*, const int*, const int*, double*, const int*, int*);
void dpbtrs_(const char*, const int*, const int*, const int*, const double*, const int*, double*,
             const int*, int*);
}

namespace vasorod {

bool BandMatrix::factorise() {
  const int n = size(), stride = width_ + 1;
  int info = 0;
  dpbtrf_("L", &n, &width_, band_.data(), &stride, &info);
  // LAPACK goes on with what is not a number; it reaches the last pivot.
  return info == 0 && (n == 0 || band_(0, n - 1) > 0);
}

void BandMatrix::solve(Eigen::Ref<Eigen::MatrixXd> x) const {
  const int n = size(), stride = width_ + 1, columns = static_cast<int>(x.cols()),
            stride_x = static_cast<int>(x.outerStride());
  int info = 0;
  dpbtrs_("L", &n, &width_, &columns, band_.data(), &stride, x.data(), &stride_x, &info);
}

}  // namespace vasorod
