#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "sections/banded_cholesky.h"

namespace vasorod {
namespace {

Eigen::MatrixXd some_matrix(int size, int width) {
  Eigen::MatrixXd a = Eigen::MatrixXd::Zero(size, size);
  for (int i = 0; i < size; ++i)
    for (int j = std::max(0, i - width); j <= i; ++j)
      a(i, j) = a(j, i) = i == j ? 2 * width + 1 : std::sin(1.3 * i + 0.7 * j);
  return a;
}

TEST(BandMatrix, SolvesAsADenseFactorDoes) {
  const int size = 23, width = 5;
  const Eigen::MatrixXd a = some_matrix(size, width);
  BandMatrix band(size, width);
  for (int row = 0; row < size; row += 4)
    for (int column = std::max(0, row - 8); column <= row; column += 4) {
      const int rows = std::min(4, size - row), columns = std::min(4, size - column);
      Eigen::MatrixXd block = a.block(row, column, rows, columns);
      for (int i = 0; i < rows; ++i)
        for (int j = 0; j < columns; ++j)
          if (row + i - column - j > width) block(i, j) = 0;
      // Entries beyond the width are zero and not added.
      for (int i = 0; i < rows; ++i)
        for (int j = 0; j < columns; ++j)
          if (row + i >= column + j && row + i - column - j <= width)
            band.lower(row + i, column + j) += block(i, j);
    }
  EXPECT_EQ(band.diagonal(), a.diagonal());
  ASSERT_TRUE(band.factorise());
  Eigen::MatrixXd x = Eigen::MatrixXd::Random(size, 2);
  const Eigen::MatrixXd right = x;
  band.solve(x);
  EXPECT_LT((a * x - right).norm(), 1e-12);
}

TEST(BandMatrix, ABlockAcrossTheDiagonalGivesItsLowerPart) {
  BandMatrix band(3, 2);
  const Eigen::Matrix2d block{{1, 2}, {3, 4}};
  band.add(1, 1, block);
  EXPECT_EQ(band.lower(1, 1), 1);
  EXPECT_EQ(band.lower(2, 1), 3);
  EXPECT_EQ(band.lower(2, 2), 4);
}

TEST(BandMatrix, ANegativePivotAndNoNumberFail) {
  BandMatrix band(3, 1);
  band.add_to_diagonal(Eigen::Vector3d(1, -1, 1));
  EXPECT_FALSE(band.factorise());
  BandMatrix none(3, 1);
  none.add_to_diagonal(Eigen::Vector3d(1, std::nan(""), 1));
  EXPECT_FALSE(none.factorise());
}

}  // namespace
}  // namespace vasorod
