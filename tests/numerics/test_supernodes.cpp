#include <gtest/gtest.h>

#include "numerics/analysed_grid.h"

namespace vasorod {
namespace {

using namespace testing;

TEST(Supernodes, PlacesFindTheRowsOfTheParent) {
  const Analysed a(grid(20));
  const Supernodes nodes(*a.factor);
  int children = 0, columns = 0;
  for (int k = 0; k < nodes.size(); ++k) {
    const Supernode node = nodes[k];
    EXPECT_EQ(node.start, columns);
    columns += node.columns;
    nodes.for_children(k, [&](int c) {
      ++children;
      const Supernode child = nodes[c];
      for (int i = 0; i < child.below; ++i)
        ASSERT_EQ(node.row[child.place[i]], child.row[child.columns + i]);
    });
  }
  EXPECT_EQ(columns, nodes.unknowns());
  EXPECT_EQ(children, nodes.size() - 1) << "the grid is connected: one tree";
}

TEST(Supernodes, SubtreesAreIndependentAndHoldAllThatIsNotAboveThem) {
  const Analysed a(grid(40));
  const Supernodes nodes(*a.factor);
  std::vector<int> subtree_of(static_cast<size_t>(nodes.size()), -1);
  const std::vector<int>& tops = nodes.tops();
  ASSERT_GT(tops.size(), 12u) << "enough for several threads";
  nodes.for_subtrees(tops, 1, [&](int thread, int first, int last) {
    EXPECT_EQ(thread, 0);
    for (int k = first; k <= last; ++k) {
      EXPECT_EQ(subtree_of[static_cast<size_t>(k)], -1) << "in two subtrees";
      subtree_of[static_cast<size_t>(k)] = last;
    }
  });
  for (const int k : nodes.above()) {
    EXPECT_EQ(subtree_of[static_cast<size_t>(k)], -1);
    subtree_of[static_cast<size_t>(k)] = -2;
  }
  EXPECT_EQ(std::count(subtree_of.begin(), subtree_of.end(), -1), 0);
  // A supernode's rows below it are columns of its own subtree or of what is above.
  std::vector<int> subtree_of_column;
  for (int k = 0; k < nodes.size(); ++k)
    subtree_of_column.resize(subtree_of_column.size() + static_cast<size_t>(nodes[k].columns),
                             subtree_of[static_cast<size_t>(k)]);
  for (int k = 0; k < nodes.size(); ++k)
    for (int i = nodes[k].columns; i < nodes[k].rows; ++i) {
      const int other = subtree_of_column[static_cast<size_t>(nodes[k].row[i])];
      EXPECT_TRUE(other == -2 || other == subtree_of[static_cast<size_t>(k)]);
    }
}

}  // namespace
}  // namespace vasorod
