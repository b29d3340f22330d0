// Products and solves of dense column-major blocks with three right-hand sides: x, y and z of the
// vertices. A BLAS copies the blocks into packed buffers first, which costs more than such small
// products.
// `stride` is the distance of two columns.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <type_traits>

namespace vasorod::dense {

/// Four columns of A are read together: each entry is then used three times, and each of Y's is
/// read and written once for four columns.
constexpr int at_once = 4;

/// Factors of up to four columns, for each of the three right-hand sides.
template <class Scalar>
using Three = Scalar[3][at_once];

/// Vectors of 16 bytes, which every 64-bit x86 or ARM processor has.
template <class Scalar>
struct Packet {
  static constexpr int size = 16 / sizeof(Scalar);
  using Type [[gnu::vector_size(16)]] = Scalar;
  static Type load(const Scalar* from) {
    Type packet;
    std::memcpy(&packet, from, sizeof packet);
    return packet;
  }
  static void store(const Type& packet, Scalar* to) { std::memcpy(to, &packet, sizeof packet); }
  static Scalar sum(const Type& packet) {
    Scalar total = packet[0];
    for (int i = 1; i < size; ++i) total += packet[i];
    return total;
  }
};

/// Calls `task` with the number of columns as a constant.
template <class Task>
void with_columns(int columns, Task task) {
  switch (columns) {
    case 1:
      return task(std::integral_constant<int, 1>{});
    case 2:
      return task(std::integral_constant<int, 2>{});
    case 3:
      return task(std::integral_constant<int, 3>{});
    default:
      return task(std::integral_constant<int, at_once>{});
  }
}

/// Y -= A M for a few columns of A.
template <int columns, class Scalar>
void subtract_few(int rows, const Scalar* a, std::ptrdiff_t stride, const Three<Scalar>& m,
                  Scalar* y, std::ptrdiff_t stride_y) {
  using P = Packet<Scalar>;
  int i = 0;
  for (; i + P::size <= rows; i += P::size)
    for (int r = 0; r < 3; ++r) {
      auto sum = P::load(y + r * stride_y + i);
      for (int k = 0; k < columns; ++k) sum -= P::load(a + k * stride + i) * m[r][k];
      P::store(sum, y + r * stride_y + i);
    }
  for (; i < rows; ++i)
    for (int r = 0; r < 3; ++r)
      for (int k = 0; k < columns; ++k) y[r * stride_y + i] -= a[k * stride + i] * m[r][k];
}

/// M = A^T X for a few columns of A.
template <int columns, class Scalar>
void dot_few(int rows, const Scalar* a, std::ptrdiff_t stride, const Scalar* x,
             std::ptrdiff_t stride_x, Three<Scalar>& m) {
  using P = Packet<Scalar>;
  typename P::Type sum[3][columns] = {};
  int i = 0;
  for (; i + P::size <= rows; i += P::size)
    for (int r = 0; r < 3; ++r) {
      const auto of_x = P::load(x + r * stride_x + i);
      for (int k = 0; k < columns; ++k) sum[r][k] += P::load(a + k * stride + i) * of_x;
    }
  for (int r = 0; r < 3; ++r)
    for (int k = 0; k < columns; ++k) {
      m[r][k] = P::sum(sum[r][k]);
      for (int rest = i; rest < rows; ++rest)
        m[r][k] += a[k * stride + rest] * x[r * stride_x + rest];
    }
}

/// X = L^-1 X.
template <class Scalar>
void divide_down(int size, const Scalar* l, std::ptrdiff_t stride, Scalar* x,
                 std::ptrdiff_t stride_x) {
  Three<Scalar> m;
  for (int j = 0; j < size; j += at_once) {
    const Scalar* block = l + j * stride + j;
    const int few = std::min(at_once, size - j);
    for (int r = 0; r < 3; ++r)
      for (int k = 0; k < few; ++k) {
        Scalar& value = x[r * stride_x + j + k];
        for (int h = 0; h < k; ++h) value -= block[h * stride + k] * m[r][h];
        m[r][k] = value /= block[k * stride + k];
      }
    with_columns(few, [&](auto columns) {
      subtract_few<columns>(size - j - few, block + few, stride, m, x + j + few, stride_x);
    });
  }
}

/// X = L^-T X.
template <class Scalar>
void divide_up(int size, const Scalar* l, std::ptrdiff_t stride, Scalar* x,
               std::ptrdiff_t stride_x) {
  Three<Scalar> m;
  for (int end = size; end > 0;) {
    const int j = (end - 1) / at_once * at_once, few = end - j;
    const Scalar* block = l + j * stride + j;
    with_columns(few, [&](auto columns) {
      dot_few<columns>(size - end, block + few, stride, x + end, stride_x, m);
    });
    for (int r = 0; r < 3; ++r)
      for (int k = few - 1; k >= 0; --k) {
        Scalar& value = x[r * stride_x + j + k];
        value -= m[r][k];
        for (int h = k + 1; h < few; ++h) value -= block[k * stride + h] * x[r * stride_x + j + h];
        value /= block[k * stride + k];
      }
    end = j;
  }
}

/// X = L^-1 X, or L^-T X.
template <class Scalar>
void divide_three(bool transposed, int size, const Scalar* l, std::ptrdiff_t stride, Scalar* x,
                  std::ptrdiff_t stride_x) {
  if (transposed)
    divide_up(size, l, stride, x, stride_x);
  else
    divide_down(size, l, stride, x, stride_x);
}

/// Y -= A X, or A^T X.
template <class Scalar>
void subtract_product_three(bool transposed, int rows, int columns, const Scalar* a,
                            std::ptrdiff_t stride, const Scalar* x, std::ptrdiff_t stride_x,
                            Scalar* y, std::ptrdiff_t stride_y) {
  Three<Scalar> m;
  for (int j = 0; j < columns; j += at_once) {
    const int few = std::min(at_once, columns - j);
    const Scalar* block = a + j * stride;
    with_columns(few, [&](auto count) {
      if (transposed) {
        dot_few<count>(rows, block, stride, x, stride_x, m);
        for (int r = 0; r < 3; ++r)
          for (int k = 0; k < few; ++k) y[r * stride_y + j + k] -= m[r][k];
      } else {
        for (int r = 0; r < 3; ++r) std::copy_n(x + r * stride_x + j, few, m[r]);
        subtract_few<count>(rows, block, stride, m, y, stride_y);
      }
    });
  }
}

}  // namespace vasorod::dense
