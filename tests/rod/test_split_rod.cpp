#include <gtest/gtest.h>

#include "geometry/rigid_motion.h"
#include "rod/split_rod.h"

namespace vasorod {
namespace {

// Root branch of three elements, two branches of two elements at its end; all helical.
RodTree fork() {
  RodTree tree;
  tree.rest.push_back({});
  tree.radius.push_back(1);
  auto grow = [&](int parent, int from, int elements, const Vec6& strain) {
    RodBranch branch;
    branch.parent = parent;
    branch.nodes = {from};
    for (int k = 0; k < elements; ++k) {
      RodElement e;
      e.first = branch.nodes.back();
      e.second = tree.node_count();
      e.length = 2;
      e.rest_strain = e.natural_strain = strain;
      e.stiffness = Mat6::Identity() * (k + 1);
      tree.rest.push_back(tree.rest[static_cast<size_t>(e.first)] * exp_motion(e.length * strain));
      tree.radius.push_back(1.0 + 0.5 * static_cast<double>(tree.rest.size()));
      branch.nodes.push_back(e.second);
      branch.elements.push_back(static_cast<int>(tree.elements.size()));
      tree.elements.push_back(e);
    }
    tree.branches.push_back(branch);
  };
  grow(-1, 0, 3, (Vec6() << 0, 0, 1, 0.1, 0.05, 0.02).finished());
  grow(0, 3, 2, (Vec6() << 0, 0, 1, 0.2, 0, 0).finished());
  grow(0, 3, 2, (Vec6() << 0, 0, 1, -0.2, 0.1, 0).finished());
  return tree;
}

double length_of(const RodTree& tree) {
  double sum = 0;
  for (const RodElement& e : tree.elements) sum += e.length;
  return sum;
}

// Every element's strain maps its first node's rest frame to its second's.
void expect_consistent(const RodTree& tree) {
  for (const RodElement& e : tree.elements) {
    const Pose& a = tree.rest[static_cast<size_t>(e.first)];
    const Vec6 log = log_motion(a.inverse() * tree.rest[static_cast<size_t>(e.second)]);
    EXPECT_NEAR((log - e.length * e.rest_strain).norm(), 0, 1e-13);
    EXPECT_LT(e.first, e.second);
  }
  for (const RodBranch& b : tree.branches) {
    ASSERT_EQ(b.nodes.size(), b.elements.size() + 1);
    for (size_t k = 0; k < b.elements.size(); ++k) {
      EXPECT_EQ(tree.elements[static_cast<size_t>(b.elements[k])].first, b.nodes[k]);
      EXPECT_EQ(tree.elements[static_cast<size_t>(b.elements[k])].second, b.nodes[k + 1]);
    }
    if (b.parent >= 0) {
      EXPECT_EQ(b.nodes.front(), tree.branches[static_cast<size_t>(b.parent)].nodes.back());
    }
  }
}

TEST(SplitRod, InsertingANodeChangesNeitherShapeNorLength) {
  const RodTree tree = fork();
  const RodPart part = split_rod(tree, 1, 0.7);
  EXPECT_EQ(part.tree.node_count(), tree.node_count() + 1);
  expect_consistent(part.tree);
  EXPECT_NEAR(length_of(part.tree), length_of(tree), 1e-14);
  for (size_t k = 0; k < tree.rest.size(); ++k) {
    const Pose& same = part.tree.rest[static_cast<size_t>(part.node_of[k])];
    EXPECT_EQ((same.position - tree.rest[k].position).norm(), 0);
  }
  EXPECT_EQ(part.cut_node, 2);
  const Pose at = frame_at(tree, tree.rest, 1, 0.7);
  EXPECT_NEAR((part.tree.rest[2].position - at.position).norm(), 0, 1e-14);
  EXPECT_NEAR(part.tree.radius[2], 0.65 * tree.radius[1] + 0.35 * tree.radius[2], 1e-14);
}

TEST(SplitRod, TheTwoSidesOfACutAddUp) {
  const RodTree tree = fork();
  const RodPart near = cut_rod(tree, 1, 0.7, RodSide::towards_root);
  const RodPart far = cut_rod(tree, 1, 0.7, RodSide::away_from_root);
  expect_consistent(near.tree);
  expect_consistent(far.tree);
  EXPECT_EQ(near.tree.branches.size(), 1U);
  EXPECT_EQ(far.tree.branches.size(), 3U);
  EXPECT_EQ(near.tree.branches[0].nodes.back(), near.cut_node);
  EXPECT_EQ(far.cut_node, 0);
  EXPECT_NEAR(length_of(near.tree), 2.7, 1e-14);
  EXPECT_NEAR(length_of(near.tree) + length_of(far.tree), length_of(tree), 1e-13);
  EXPECT_EQ(far.node_of[0], -1);
  EXPECT_EQ(near.node_of[5], -1);
}

TEST(SplitRod, CuttingABranchKeepsItsSibling) {
  const RodTree tree = fork();
  const RodPart near = cut_rod(tree, 4, 1.0, RodSide::towards_root);
  expect_consistent(near.tree);
  EXPECT_EQ(near.tree.branches.size(), 3U);
  EXPECT_NEAR(length_of(near.tree), 14 - 1, 1e-13);
  const RodPart far = cut_rod(tree, 4, 1.0, RodSide::away_from_root);
  EXPECT_EQ(far.tree.branches.size(), 1U);
  EXPECT_EQ(far.tree.branches[0].parent, -1);
  EXPECT_NEAR(length_of(far.tree), 1, 1e-14);
}

TEST(SplitRod, ACutAtANodeMakesNoElementWithoutLength) {
  const RodTree tree = fork();
  EXPECT_EQ(split_rod(tree, 1, 0).tree.node_count(), tree.node_count());
  const RodPart far = cut_rod(tree, 1, 2, RodSide::away_from_root);
  expect_consistent(far.tree);
  EXPECT_NEAR(length_of(far.tree), 10, 1e-13);
}

TEST(SplitRod, SidesAreToldFromTheNode) {
  const RodTree tree = fork();
  EXPECT_EQ(side_of(tree, 1, 0.7, 0), RodSide::towards_root);
  EXPECT_EQ(side_of(tree, 1, 0.7, 1), RodSide::towards_root);
  EXPECT_EQ(side_of(tree, 1, 0.7, 2), RodSide::away_from_root);
  EXPECT_EQ(side_of(tree, 1, 0.7, 7), RodSide::away_from_root);
  EXPECT_EQ(side_of(tree, 4, 1.0, 7), RodSide::towards_root);
}

}  // namespace
}  // namespace vasorod
