#include <Eigen/Dense>
#include <gtest/gtest.h>
#include <random>

#include "numerics/sparse_sum.h"

namespace vasorod {
namespace {

using Matrix = Eigen::SparseMatrix<double>;

Matrix drawn(int size, int entries, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_int_distribution<int> place(0, size - 1);
  std::uniform_real_distribution<double> value(-1, 1);
  std::vector<Eigen::Triplet<double>> triplets;
  for (int k = 0; k < entries; ++k)
    triplets.emplace_back(place(random), place(random), value(random));
  Matrix matrix(size, size);
  matrix.setFromTriplets(triplets.begin(), triplets.end());
  return matrix;
}

TEST(SparseSum, IsEigensOwnAlsoOfEmptyMatricesAndOnesInEachOther) {
  const Matrix a = drawn(30, 200, 1), b = drawn(30, 60, 2), empty(30, 30);
  for (const auto& [left, right] :
       {std::pair{a, b}, {b, a}, {a, a}, {a, empty}, {empty, b}, {empty, empty}}) {
    const Matrix sum = sparse_sum(left, right), expected = left + right;
    EXPECT_TRUE(sum.isCompressed());
    ASSERT_EQ(sum.nonZeros(), expected.nonZeros());
    EXPECT_EQ(Eigen::MatrixXd(sum), Eigen::MatrixXd(expected));
    for (int column = 0; column < sum.cols(); ++column)
      for (Matrix::InnerIterator one(sum, column), other(expected, column); one; ++one, ++other)
        EXPECT_EQ(one.row(), other.row());
  }
  EXPECT_EQ(sparse_sum(Matrix(0, 0), Matrix(0, 0)).nonZeros(), 0);
}

}  // namespace
}  // namespace vasorod
