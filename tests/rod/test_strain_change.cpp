#include <gtest/gtest.h>

#include "rod/strain_change.h"

namespace vasorod {
namespace {

// A parent of two elements (nodes 0 1 2) and a side branch of `count` elements from node 2.
RodTree forked(int count) {
  RodTree rod;
  rod.rest.resize(3 + static_cast<size_t>(count));
  RodBranch parent{"parent", {0, 1, 2}, {0, 1}, -1}, side{"side", {2}, {}, 0};
  const auto element = [&](int first, int second) {
    RodElement e;
    e.first = first;
    e.second = second;
    e.length = 1;
    rod.elements.push_back(e);
  };
  element(0, 1);
  element(1, 2);
  for (int k = 0; k < count; ++k) {
    side.nodes.push_back(3 + k);
    side.elements.push_back(2 + k);
    element(2 + k, 3 + k);
  }
  rod.branches = {parent, side};
  return rod;
}

std::vector<ElementChange> stretched(const std::vector<double>& v3) {
  std::vector<ElementChange> changes;
  for (const double v : v3) {
    ElementChange change;
    change.strain[2] = v;
    changes.push_back(change);
  }
  changes[2].at_fork = true;
  return changes;
}

TEST(RodChange, TheTurningElementOfAForkDoesNotSpoilItsNodes) {
  const auto nodes = node_changes(forked(2), stretched({1.0, 1.2, 9.0, 1.4}));
  EXPECT_DOUBLE_EQ(nodes[1].strain[2], 1.1);
  EXPECT_DOUBLE_EQ(nodes[2].strain[2], 1.2);
  EXPECT_DOUBLE_EQ(nodes[3].strain[2], 1.4);
  EXPECT_DOUBLE_EQ(nodes[4].strain[2], 1.4);
}

TEST(RodChange, ABranchOfOneElementHasNothingElse) {
  const auto nodes = node_changes(forked(1), stretched({1.0, 1.2, 1.6}));
  EXPECT_DOUBLE_EQ(nodes[2].strain[2], 1.2);
  EXPECT_DOUBLE_EQ(nodes[3].strain[2], 1.6);
}

// Where the axis turns away from d3, v3 is not its stretch and may have any sign.
TEST(RodChange, TheStretchAtAForkIsThatOfTheLength) {
  ElementChange change;
  change.strain << 0.6, 0, -0.8, 0, 0, 0;
  change.change << 0.1, 0, -0.8, 0, 0, 0;  // at rest (0.5, 0, 0)
  change.at_fork = true;
  EXPECT_DOUBLE_EQ(change.stretch(), 2);
  change.strain << 0.3, 0, 1.1, 0, 0, 0;
  change.change << 0.3, 0, 0.1, 0, 0, 0;
  change.at_fork = false;
  EXPECT_DOUBLE_EQ(change.stretch(), 1.1);
}

}  // namespace
}  // namespace vasorod
