#include <Eigen/Cholesky>
#include <gtest/gtest.h>

#include "numerics/dense_blocks.h"

namespace vasorod {
namespace {

// Sizes on both sides of that at which trsv takes the place of our columns, in blocks that are
// taller than wide; three right-hand sides are on another way than two.
template <class Scalar>
void expect_division(Scalar tolerance) {
  using Matrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;
  for (const int size : {1, 2, 3, 4, 5, 7, 63, 64, 65, 130})
    for (const bool transposed : {false, true})
      for (const int count : {1, 2, 3}) {
        Matrix l = Matrix::Random(size + 5, size);
        l.diagonal().array() += 2 + Scalar(size) / 4;
        const auto lower = l.topRows(size).template triangularView<Eigen::Lower>();
        const Matrix b = Matrix::Random(size + 2, count);
        Matrix x = b, expected = b;
        if (transposed)
          expected.topRows(size) = lower.transpose().solve(b.topRows(size));
        else
          expected.topRows(size) = lower.solve(b.topRows(size));
        dense::divide(transposed, size, count, l.data(), size + 5, x.data(), size + 2);
        EXPECT_LT((x - expected).norm(), tolerance * expected.norm())
            << size << " columns, " << count << " right-hand sides";
        EXPECT_EQ(x.bottomRows(2), b.bottomRows(2)) << "what lies after them stays";
      }
}

TEST(DenseBlocks, DivisionIsThatByALowerTriangleOrItsTranspose) {
  expect_division<double>(1e-14);
  expect_division<float>(2e-6F);
}

template <class Scalar>
void expect_product(Scalar tolerance) {
  using Matrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;
  for (const int rows : {1, 3, 4, 11, 50})
    for (const int columns : {1, 2, 3, 4, 5, 30})
      for (const bool transposed : {false, true})
        for (const int count : {1, 2, 3}) {
          const int in = transposed ? rows : columns, out = transposed ? columns : rows;
          const Matrix a = Matrix::Random(rows + 5, columns), x = Matrix::Random(in + 1, count),
                       before = Matrix::Random(out + 2, count);
          Matrix y = before, expected = before;
          const auto block = a.topRows(rows);
          if (transposed)
            expected.topRows(out) -= block.transpose() * x.topRows(in);
          else
            expected.topRows(out) -= block * x.topRows(in);
          dense::subtract_product(transposed, rows, columns, count, a.data(), rows + 5, x.data(),
                                  in + 1, y.data(), out + 2);
          EXPECT_LT((y - expected).norm(), tolerance * expected.norm())
              << rows << " x " << columns << ", " << count << " right-hand sides";
          EXPECT_EQ(y.bottomRows(2), before.bottomRows(2)) << "what lies after them stays";
        }
}

TEST(DenseBlocks, ProductsAreSubtracted) {
  expect_product<double>(1e-14);
  expect_product<float>(2e-6F);
}

}  // namespace
}  // namespace vasorod
