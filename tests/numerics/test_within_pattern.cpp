#include <gtest/gtest.h>

#include "numerics/within_pattern.h"

namespace vasorod {
namespace {

using Matrix = Eigen::SparseMatrix<double>;

Matrix of(int size, const std::vector<Eigen::Triplet<double>>& entries) {
  Matrix matrix(size, size);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

const Matrix wide = of(4, {{0, 0, 1}, {2, 0, 2}, {3, 0, 3}, {1, 1, 4}, {0, 2, 5}, {3, 3, 6}});
const Matrix narrow = of(4, {{2, 0, 10}, {1, 1, 20}, {3, 3, 30}});

TEST(WithinPattern, SumsAsEigenDoes) {
  Matrix sum = wide;
  for (const double factor : {0.5, -2.0}) {  // what `sum` held before is replaced
    add_within(wide, factor, narrow, sum);
    const Matrix expected = wide + factor * narrow;
    EXPECT_EQ(sum.toDense(), expected.toDense());
    EXPECT_EQ(sum.nonZeros(), wide.nonZeros());
  }
}

TEST(WithinPattern, PadsWithZeros) {
  Matrix padded = narrow;
  ASSERT_TRUE(pad(wide, padded));
  EXPECT_EQ(padded.toDense(), narrow.toDense());
  EXPECT_EQ(padded.nonZeros(), wide.nonZeros());
  ASSERT_TRUE(pad(wide, padded)) << "its own pattern";
  EXPECT_EQ(padded.toDense(), narrow.toDense());
}

TEST(WithinPattern, IsTheSameWhereTheEntriesAreAtTheSamePlaces) {
  EXPECT_TRUE(same_pattern(wide, 2 * wide));
  EXPECT_FALSE(same_pattern(wide, narrow));
  EXPECT_FALSE(same_pattern(narrow, of(4, {{2, 0, 10}, {1, 1, 20}, {3, 2, 30}})));  // a column
  EXPECT_FALSE(same_pattern(narrow, of(4, {{1, 0, 10}, {1, 1, 20}, {3, 3, 30}})));  // a row
  EXPECT_FALSE(same_pattern(of(3, {}), of(4, {})));
}

TEST(WithinPattern, WhatThePatternLacksIsLeftAsItIs) {
  for (Matrix other : {of(4, {{1, 0, 1}}), of(4, {{3, 2, 1}}), of(3, {{0, 0, 1}})}) {
    const Matrix before = other;
    EXPECT_FALSE(pad(wide, other));
    EXPECT_EQ(other.toDense(), before.toDense());
    EXPECT_EQ(other.nonZeros(), before.nonZeros());
  }
}

}  // namespace
}  // namespace vasorod
