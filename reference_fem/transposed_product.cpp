#include "reference_fem/transposed_product.h"

// Declared here and not through OpenBLAS's cblas.h, because other BLAS packages use that file name.
extern "C" void dgemm_(const char* transpose_a, const char* transpose_b, const int* m, const int* n,
                       const int* k, const double* alpha, const double* a, const int* lda,
                       const double* b, const int* ldb, const double* beta, double* c,
                       const int* ldc);

namespace vasorod::fem {

void transposed_product(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b,
                        Eigen::Ref<Eigen::MatrixXd> c) {
  const int m = static_cast<int>(a.cols()), n = static_cast<int>(b.cols()),
            k = static_cast<int>(a.rows()), ldc = static_cast<int>(c.outerStride());
  const double one = 1, zero = 0;
  dgemm_("T", "N", &m, &n, &k, &one, a.data(), &k, b.data(), &k, &zero, c.data(), &ldc);
}

}  // namespace vasorod::fem
