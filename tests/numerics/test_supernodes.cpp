#include <gtest/gtest.h>
#include <mutex>

#include "numerics/analysed_grid.h"

namespace vasorod {
namespace {

using namespace testing;

TEST(Supernodes, PlacesFindTheRowsOfTheParent) {
  const AnalysedGrid a(20);
  int children = 0, columns = 0;
  for (int k = 0; k < a.nodes.size(); ++k) {
    const Supernode node = a.nodes[k];
    EXPECT_EQ(node.start, columns);
    columns += node.columns;
    a.nodes.for_children(k, [&](int c) {
      ++children;
      const Supernode child = a.nodes[c];
      for (int i = 0; i < child.below; ++i) {
        ASSERT_EQ(node.row[child.place[i]], child.row[child.columns + i]);
        ASSERT_EQ(child.place[i] < node.columns, i < child.of_parent);
      }
    });
  }
  EXPECT_EQ(columns, a.nodes.unknowns());
  EXPECT_EQ(children, a.nodes.size() - 1) << "the grid is connected: one tree";
}

TEST(Supernodes, SubtreesAreIndependent) {
  const AnalysedGrid a(40);
  ASSERT_GT(a.nodes.subtrees().size(), 12u) << "enough for several threads";
  constexpr int above = -1;
  std::vector<int> subtree_of(static_cast<size_t>(a.nodes.size()), above);
  for (const auto& [first, last] : a.nodes.subtrees())
    for (int k = first; k <= last; ++k) {
      EXPECT_EQ(subtree_of[static_cast<size_t>(k)], above) << "in two subtrees";
      subtree_of[static_cast<size_t>(k)] = last;
    }
  // A supernode's rows below it are columns of its own subtree or of what is above.
  std::vector<int> subtree_of_column;
  for (int k = 0; k < a.nodes.size(); ++k)
    subtree_of_column.resize(subtree_of_column.size() + static_cast<size_t>(a.nodes[k].columns),
                             subtree_of[static_cast<size_t>(k)]);
  for (int k = 0; k < a.nodes.size(); ++k)
    for (int i = a.nodes[k].columns; i < a.nodes[k].rows; ++i) {
      const int other = subtree_of_column[static_cast<size_t>(a.nodes[k].row[i])];
      EXPECT_TRUE(other == above || other == subtree_of[static_cast<size_t>(k)]);
    }
}

TEST(Supernodes, EachIsVisitedOnceAfterThoseBelowItOrBefore) {
  const AnalysedGrid a(40);
  for (const int threads : {1, 2, 7}) {
    std::mutex one;
    std::vector<int> up, down;
    const auto see = [&](std::vector<int>& seen) {
      return [&](int k, int thread, int share) {
        const std::lock_guard<std::mutex> alone(one);
        EXPECT_LT(thread, threads);
        EXPECT_TRUE(share == 1 || (share == threads && thread == 0));
        seen.push_back(k);
      };
    };
    a.nodes.upwards(threads, see(up));
    a.nodes.downwards(threads, see(down));
    for (const std::vector<int>& seen : {up, std::vector<int>(down.rbegin(), down.rend())}) {
      ASSERT_EQ(seen.size(), static_cast<size_t>(a.nodes.size())) << threads;
      std::vector<char> done(seen.size(), 0);
      for (const int k : seen) {
        a.nodes.for_children(k, [&](int c) { EXPECT_TRUE(done[static_cast<size_t>(c)]); });
        EXPECT_FALSE(done[static_cast<size_t>(k)]) << "twice";
        done[static_cast<size_t>(k)] = 1;
      }
    }
  }
}

}  // namespace
}  // namespace vasorod
