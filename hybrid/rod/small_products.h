// Products of 3 x 3 matrices, written out so that they are inlined where Eigen calls a function.
#pragma once

#include <vasorod/types.h>

/// Compiles a function twice, with and without fused multiply-add and four-wide registers; the
/// version for the processor is selected at program start. Only for plain loops, because Eigen's
/// own vector types do not change.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__)
#define VASOROD_VECTORIZED __attribute__((target_clones("fma", "default")))
#else
#define VASOROD_VECTORIZED
#endif
#define VASOROD_INLINE __attribute__((always_inline))

namespace vasorod {

/// a b.
template <class A, class B>
[[gnu::always_inline]] inline Mat3 times(const A& a, const B& b) {
  Mat3 r;
  for (int c = 0; c < 3; ++c)
    for (int i = 0; i < 3; ++i) r(i, c) = a(i, 0) * b(0, c) + a(i, 1) * b(1, c) + a(i, 2) * b(2, c);
  return r;
}

/// a^T b.
template <class A, class B>
[[gnu::always_inline]] inline Mat3 transposed_times(const A& a, const B& b) {
  Mat3 r;
  for (int c = 0; c < 3; ++c)
    for (int i = 0; i < 3; ++i) r(i, c) = a(0, i) * b(0, c) + a(1, i) * b(1, c) + a(2, i) * b(2, c);
  return r;
}

/// a^T b + c^T d.
template <class A, class B, class C, class D>
[[gnu::always_inline]] inline Mat3 transposed_times(const A& a, const B& b, const C& c,
                                                    const D& d) {
  Mat3 r;
  for (int k = 0; k < 3; ++k)
    for (int i = 0; i < 3; ++i)
      r(i, k) = a(0, i) * b(0, k) + a(1, i) * b(1, k) + a(2, i) * b(2, k) + c(0, i) * d(0, k) +
                c(1, i) * d(1, k) + c(2, i) * d(2, k);
  return r;
}

/// hat(t) a: columns t x a_c.
template <class A>
[[gnu::always_inline]] inline Mat3 cross_columns(const Vec3& t, const A& a) {
  Mat3 r;
  for (int c = 0; c < 3; ++c) {
    r(0, c) = t[1] * a(2, c) - t[2] * a(1, c);
    r(1, c) = t[2] * a(0, c) - t[0] * a(2, c);
    r(2, c) = t[0] * a(1, c) - t[1] * a(0, c);
  }
  return r;
}

/// a hat(t): rows a_r x t.
template <class A>
[[gnu::always_inline]] inline Mat3 cross_rows(const A& a, const Vec3& t) {
  Mat3 r;
  for (int i = 0; i < 3; ++i) {
    r(i, 0) = a(i, 1) * t[2] - a(i, 2) * t[1];
    r(i, 1) = a(i, 2) * t[0] - a(i, 0) * t[2];
    r(i, 2) = a(i, 0) * t[1] - a(i, 1) * t[0];
  }
  return r;
}

/// a^T hat(t): rows (column i of a) x t.
template <class A>
[[gnu::always_inline]] inline Mat3 transposed_cross(const A& a, const Vec3& t) {
  Mat3 r;
  for (int i = 0; i < 3; ++i) {
    r(i, 0) = a(1, i) * t[2] - a(2, i) * t[1];
    r(i, 1) = a(2, i) * t[0] - a(0, i) * t[2];
    r(i, 2) = a(0, i) * t[1] - a(1, i) * t[0];
  }
  return r;
}

}  // namespace vasorod
