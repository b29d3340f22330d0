#include <Eigen/Core>
#include <gtest/gtest.h>

#include "numerics/block_pattern.h"

namespace vasorod {
namespace {

// Nodes of one, three, two and six unknowns; couples given twice and in either order.
struct Fixture {
  std::vector<int> sizes{1, 3, 2, 6};
  std::vector<std::pair<int, int>> couples{{0, 2}, {3, 1}, {1, 3}, {2, 3}, {2, 2}};
  BlockPattern pattern{sizes};
  Eigen::SparseMatrix<double> matrix;
  Fixture() {
    for (const auto& [i, j] : couples) pattern.couple(i, j);
    matrix = pattern.build();
  }
  bool coupled(int i, int j) const {
    if (i == j) return true;
    for (const auto& [a, b] : couples)
      if ((a == i && b == j) || (a == j && b == i)) return true;
    return false;
  }
  int node_of(int unknown) const {
    int node = 0;
    while (unknown >= pattern.first_unknown(node) + sizes[static_cast<size_t>(node)]) ++node;
    return node;
  }
};

TEST(BlockPattern, HoldsTheLowerTriangleOfEveryCoupledBlock) {
  Fixture f;
  ASSERT_EQ(f.matrix.rows(), 12);
  ASSERT_EQ(f.matrix.cols(), 12);
  EXPECT_TRUE(f.matrix.isCompressed());
  for (int k = 0; k < f.matrix.nonZeros(); ++k) {
    EXPECT_EQ(f.matrix.valuePtr()[k], 0);
    f.matrix.valuePtr()[k] = 1;
  }
  const Eigen::MatrixXd dense(f.matrix);
  for (int r = 0; r < 12; ++r)
    for (int c = 0; c < 12; ++c)
      EXPECT_EQ(dense(r, c), r >= c && f.coupled(f.node_of(r), f.node_of(c)) ? 1 : 0)
          << r << ' ' << c;
}

TEST(BlockPattern, RowsRiseInEveryColumn) {
  const Fixture f;
  for (int c = 0; c < 12; ++c)
    for (int k = f.matrix.outerIndexPtr()[c] + 1; k < f.matrix.outerIndexPtr()[c + 1]; ++k)
      EXPECT_LT(f.matrix.innerIndexPtr()[k - 1], f.matrix.innerIndexPtr()[k]) << c;
}

// Blocks written where place() and stride() say are found where their unknowns are.
TEST(BlockPattern, BlocksAreWhereTheirPlacesSay) {
  Fixture f;
  Eigen::MatrixXd expected = Eigen::MatrixXd::Zero(12, 12);
  double next = 1;
  for (int column = 0; column < 4; ++column)
    for (int row = column; row < 4; ++row) {
      if (!f.coupled(row, column)) continue;
      const int height = f.sizes[static_cast<size_t>(row)],
                width = f.sizes[static_cast<size_t>(column)];
      int at = f.pattern.place(row, column), stride = f.pattern.stride(column);
      for (int c = 0; c < width; ++c) {
        // On the diagonal a column begins at its own row.
        for (int r = row == column ? c : 0; r < height; ++r) {
          expected(f.pattern.first_unknown(row) + r, f.pattern.first_unknown(column) + c) = next;
          f.matrix.valuePtr()[at + r] = next++;
        }
        at += stride--;
      }
    }
  EXPECT_EQ(next - 1, static_cast<double>(f.matrix.nonZeros()));
  EXPECT_EQ(Eigen::MatrixXd(f.matrix), expected);
}

}  // namespace
}  // namespace vasorod
