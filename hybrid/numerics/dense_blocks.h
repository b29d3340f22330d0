// The BLAS's and LAPACK's operations on dense column-major blocks of a factor, in both precisions.
// `stride` is the distance of two columns. Declared here instead of including OpenBLAS's cblas.h,
// because other BLAS packages install a header of the same name.
#pragma once

#include <cstddef>
#include <type_traits>

#include "numerics/three_columns.h"

extern "C" {
void dpotrf_(const char*, const int*, double*, const int*, int*);
void spotrf_(const char*, const int*, float*, const int*, int*);
void dsyrk_(const char*, const char*, const int*, const int*, const double*, const double*,
            const int*, const double*, double*, const int*);
void ssyrk_(const char*, const char*, const int*, const int*, const float*, const float*,
            const int*, const float*, float*, const int*);
void dtrsm_(const char*, const char*, const char*, const char*, const int*, const int*,
            const double*, const double*, const int*, double*, const int*);
void strsm_(const char*, const char*, const char*, const char*, const int*, const int*,
            const float*, const float*, const int*, float*, const int*);
void dgemm_(const char*, const char*, const int*, const int*, const int*, const double*,
            const double*, const int*, const double*, const int*, const double*, double*,
            const int*);
void sgemm_(const char*, const char*, const int*, const int*, const int*, const float*,
            const float*, const int*, const float*, const int*, const float*, float*, const int*);
void dtrsv_(const char*, const char*, const char*, const int*, const double*, const int*, double*,
            const int*);
void strsv_(const char*, const char*, const char*, const int*, const float*, const int*, float*,
            const int*);
void daxpy_(const int*, const double*, const double*, const int*, double*, const int*);
void saxpy_(const int*, const float*, const float*, const int*, float*, const int*);
double ddot_(const int*, const double*, const int*, const double*, const int*);
float sdot_(const int*, const float*, const int*, const float*, const int*);
void dgemv_(const char*, const int*, const int*, const double*, const double*, const int*,
            const double*, const int*, const double*, double*, const int*);
void sgemv_(const char*, const int*, const int*, const float*, const float*, const int*,
            const float*, const int*, const float*, float*, const int*);
}

namespace vasorod::dense {

/// The one of two functions that takes such numbers.
template <class Scalar, class Double, class Single>
constexpr auto of(Double* in_double, Single* in_single) {
  if constexpr (std::is_same_v<Scalar, double>)
    return in_double;
  else
    return in_single;
}

/// A = L L^T of the lower triangle, in place; false where A is not positive definite. OpenBLAS goes
/// on with what is not a number; it reaches the last pivot.
template <class Scalar>
bool cholesky(int size, Scalar* a, int stride) {
  int info = 0;
  of<Scalar>(dpotrf_, spotrf_)("L", &size, a, &stride, &info);
  const auto last = static_cast<std::ptrdiff_t>(size - 1);
  return info == 0 && a[last * stride + last] > 0;
}

/// B = B L^-T for `rows` rows.
template <class Scalar>
void divide_rows(int rows, int columns, const Scalar* l, int stride, Scalar* b) {
  const Scalar one = 1;
  of<Scalar>(dtrsm_, strsm_)("R", "L", "T", "N", &rows, &columns, &one, l, &stride, b, &stride);
}

/// The lower triangle of C = -A A^T.
template <class Scalar>
void minus_square(int size, int columns, const Scalar* a, int stride, Scalar* c, int stride_c) {
  const Scalar minus = -1, zero = 0;
  of<Scalar>(dsyrk_, ssyrk_)("L", "N", &size, &columns, &minus, a, &stride, &zero, c, &stride_c);
}

/// C = -A B^T.
template <class Scalar>
void minus_product(int rows_a, int rows_b, int columns, const Scalar* a, const Scalar* b,
                   int stride, Scalar* c, int stride_c) {
  const Scalar minus = -1, zero = 0;
  of<Scalar>(dgemm_, sgemm_)("N", "T", &rows_a, &rows_b, &columns, &minus, a, &stride, b, &stride,
                             &zero, c, &stride_c);
}

/// x = L^-1 x, or L^-T x, column by column in the order of OpenBLAS's trsv, but without its lock,
/// at which threads with small blocks wait longer than they compute.
template <class Scalar>
void divide_small(bool transposed, int size, const Scalar* l, int stride, Scalar* x) {
  const int step = 1;
  const auto pivot = [&](int j) { return l + std::ptrdiff_t{j} * stride + j; };
  if (transposed) {
    for (int j = size - 1, after = 0; j >= 0; --j, ++after) {
      if (after > 0)
        x[j] -= of<Scalar>(ddot_, sdot_)(&after, pivot(j) + 1, &step, x + j + 1, &step);
      x[j] /= *pivot(j);
    }
    return;
  }
  for (int j = 0, after = size - 1; j < size; ++j, --after) {
    x[j] /= *pivot(j);
    const Scalar minus = -x[j];
    if (after > 0)
      of<Scalar>(daxpy_, saxpy_)(&after, &minus, pivot(j) + 1, &step, x + j + 1, &step);
  }
}

/// X = L^-1 X, or L^-T X, for `count` right-hand sides.
template <class Scalar>
void divide(bool transposed, int size, int count, const Scalar* l, int stride, Scalar* x,
            int stride_x) {
  const char* t = transposed ? "T" : "N";
  const Scalar one = 1;
  const int step = 1;
  constexpr int small = 64;  // columns; more are taken in blocks, where trsv is faster
  if (count == 3)
    divide_three(transposed, size, l, stride, x, stride_x);
  else if (count == 1 && size <= small)
    divide_small(transposed, size, l, stride, x);
  else if (count == 1)
    of<Scalar>(dtrsv_, strsv_)("L", t, "N", &size, l, &stride, x, &step);
  else
    of<Scalar>(dtrsm_, strsm_)("L", "L", t, "N", &size, &count, &one, l, &stride, x, &stride_x);
}

/// Y -= A X, or A^T X, for `count` columns of X; A has `rows` rows and `columns` columns.
template <class Scalar>
void subtract_product(bool transposed, int rows, int columns, int count, const Scalar* a,
                      int stride, const Scalar* x, int stride_x, Scalar* y, int stride_y) {
  if (count == 3) {
    subtract_product_three(transposed, rows, columns, a, stride, x, stride_x, y, stride_y);
    return;
  }
  const char* t = transposed ? "T" : "N";
  const Scalar one = 1, minus = -1;
  const int step = 1, *out = transposed ? &columns : &rows, *in = transposed ? &rows : &columns;
  if (count == 1)
    of<Scalar>(dgemv_, sgemv_)(t, &rows, &columns, &minus, a, &stride, x, &step, &one, y, &step);
  else
    of<Scalar>(dgemm_, sgemm_)(t, "N", out, &count, in, &minus, a, &stride, x, &stride_x, &one, y,
                               &stride_y);
}

}  // namespace vasorod::dense
