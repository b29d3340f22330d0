#include <gtest/gtest.h>
#include <numbers>

#include "predict/rod_scene.h"
#include "predict/small_scenes.h"

namespace vasorod {
namespace {

using namespace testing;
using Kind = EndSelector::Kind;

// A trunk along x with a branch that leaves its end along the trunk's d1.
Scene fork() {
  Scene scene;
  scene.file = "fork.yaml";
  scene.vessels = {bare_rod("branch", 4, 2), bare_rod("trunk", 10, 5)};
  RodSpec& branch = *scene.vessels[0].rod;
  branch.parent = "trunk";
  branch.tangent = Vec3::UnitX();
  branch.normal = -Vec3::UnitZ();
  scene.ends = {held("trunk", Kind::start), held("branch", Kind::end)};
  return scene;
}

TEST(AssembleRods, ABranchHangsOnItsParentsEndWhateverTheirOrder) {
  const std::vector<RodAssembly> rods = assemble_rods(fork());
  ASSERT_EQ(rods.size(), 1u);
  const RodAssembly& rod = rods[0];
  EXPECT_EQ(rod.vessels, (std::vector<std::string>{"trunk", "branch"}));
  ASSERT_EQ(rod.tree.branches.size(), 2u);
  EXPECT_EQ(rod.tree.branches[0].parent, -1);
  EXPECT_EQ(rod.tree.branches[1].parent, 0);
  EXPECT_EQ(rod.tree.branches[1].nodes.front(), rod.tree.branches[0].nodes.back());
  EXPECT_EQ(rod.tree.node_count(), 1 + 5 + 2);
  EXPECT_NO_THROW(check_tree(rod.tree));
  // The trunk: along x from the origin, d1 along y. Its d1 is the branch's direction.
  const RodTree& tree = rod.tree;
  const Pose fork = tree.rest[static_cast<size_t>(tree.branches[0].nodes.back())],
             tip = tree.rest[static_cast<size_t>(tree.branches[1].nodes.back())];
  EXPECT_LT((fork.position - Vec3(10, 0, 0)).norm(), 1e-12);
  EXPECT_LT((fork.director(1) - Vec3::UnitY()).norm(), 1e-12);
  EXPECT_LT((tip.position - Vec3(10, 4, 0)).norm(), 1e-12);
  EXPECT_LT((tip.director(3) - Vec3::UnitY()).norm(), 1e-12);
}

TEST(AssembleRods, ACurvedPieceIsDrawnAsItsArc) {
  Scene scene = bent_cantilever(10 * std::numbers::pi, 0, 8);
  RodPiece& piece = scene.vessels[0].rod->pieces[0];
  piece.curvature = Vec3(0, 0.1, 0);  // radius 10, d3 turns towards d1: from x towards y
  const RodTree tree = assemble_rods(scene)[0].tree;
  EXPECT_LT((tree.rest.back().position - Vec3(0, 20, 0)).norm(), 1e-11);
  EXPECT_LT((tree.rest.back().director(3) + Vec3::UnitX()).norm(), 1e-12);
  EXPECT_EQ(tree.elements[0].natural_strain, tree.elements[0].rest_strain);
}

TEST(AssembleRods, RefinedNodesKeepTheCoarseOnesAmongThem) {
  Scene scene = fork();
  scene.ends.push_back(held("trunk", Kind::at));
  scene.ends.back().end.at = 0.33;
  const RodTree coarse = assemble_rods(scene)[0].tree, fine = assemble_rods(scene, 3)[0].tree;
  EXPECT_EQ(coarse.elements.size(), 5u + 1u + 2u) << "one station more for at(0.33)";
  EXPECT_EQ(fine.elements.size(), 3 * coarse.elements.size());
  for (size_t b = 0; b < 2; ++b)
    for (size_t i = 0; i < coarse.branches[b].nodes.size(); ++i) {
      const Pose& one = coarse.rest[static_cast<size_t>(coarse.branches[b].nodes[i])];
      const Pose& other = fine.rest[static_cast<size_t>(fine.branches[b].nodes[3 * i])];
      EXPECT_LT((one.position - other.position).norm(), 1e-12);
    }
}

TEST(AssembleRods, ATaperIsTakenAtTheMiddleOfEachElement) {
  Scene scene = bent_cantilever(12, 1, 3);
  RodPiece& piece = scene.vessels[0].rod->pieces[0];
  piece.end_stiffness = 4 * piece.stiffness;
  const RodTree tree = assemble_rods(scene)[0].tree;
  for (int e = 0; e < 3; ++e) {
    const double share = (e + 0.5) / 3;
    EXPECT_LT(
        (tree.elements[static_cast<size_t>(e)].stiffness - (1 + 3 * share) * Mat6(piece.stiffness))
            .norm(),
        1e-9);
  }
}

TEST(AssembleRods, EndsBecomeSupportsAndLoadsOfTheirNodes) {
  Scene scene = bent_cantilever(10, 3, 4);
  scene.ends[1].force = Vec3(0, 1, 2);
  scene.ends.push_back(at("beam", Kind::end));
  scene.ends.back().fix = {false, false, true, false, false, false};
  scene.ends.push_back(at("beam", Kind::at));
  scene.ends.back().end.at = 0.5;
  scene.ends.back().rotate_deg = Vec3(0, 0, 90);
  const RodAssembly rod = assemble_rods(scene)[0];
  ASSERT_EQ(rod.conditions.supports.size(), 3u);
  EXPECT_EQ(rod.conditions.supports[0].node, 0);
  EXPECT_EQ(rod.conditions.supports[0].fixed, (std::array<bool, 6>{1, 1, 1, 1, 1, 1}));
  EXPECT_EQ(rod.conditions.supports[1].node, 4);
  EXPECT_EQ(rod.conditions.supports[1].fixed, (std::array<bool, 6>{0, 0, 1, 0, 0, 0}));
  EXPECT_EQ(rod.conditions.supports[2].node, 2);
  EXPECT_LT((rod.conditions.supports[2].motion.rotate - Vec3(0, 0, std::numbers::pi / 2)).norm(),
            1e-15);
  ASSERT_EQ(rod.conditions.loads.size(), 1u);
  EXPECT_EQ(rod.conditions.loads[0].node, 4);
  EXPECT_EQ(rod.conditions.loads[0].force, Vec3(0, 1, 2));
  EXPECT_EQ(rod.conditions.loads[0].moment, Vec3(0, 0, 3));
  ASSERT_EQ(rod.ends.size(), 3u) << "two entries for one place share it";
  EXPECT_EQ(rod.ends[1].name, "end");
  EXPECT_EQ(rod.ends[1].support, 1);
  EXPECT_EQ(rod.ends[2].name, "at(0.5)");
}

TEST(AssembleRods, NearIsTheNearerEnd) {
  Scene scene = bent_cantilever(10, 3, 4);
  scene.ends[0].end.kind = Kind::near;
  scene.ends[0].end.near = Vec3(9, 1, 1);
  scene.ends[1].end.kind = Kind::near;
  scene.ends[1].end.near = Vec3(-3, 0, 0);
  const RodAssembly rod = assemble_rods(scene)[0];
  EXPECT_EQ(rod.conditions.supports.at(0).node, 4);
  EXPECT_EQ(rod.conditions.loads.at(0).node, 0);
}

TEST(AssembleRods, WhatIsNoTreeIsRefusedWithTheVessel) {
  Scene scene = fork();
  scene.vessels[1].rod->parent = "branch";
  EXPECT_NE(refusal([&] { assemble_rods(scene); }).find("each other's parents"), std::string::npos);
  scene = fork();
  scene.vessels[0].rod->parent = "stem";
  EXPECT_EQ(refusal([&] { assemble_rods(scene); }), "fork.yaml: vessel 'stem' is not in the scene");
  scene = fork();
  scene.vessels.push_back(tube("aorta"));
  scene.vessels[0].rod->parent = "aorta";
  EXPECT_NE(refusal([&] { assemble_rods(scene); }).find("parent 'aorta' is not a bare rod"),
            std::string::npos);
  scene = fork();
  scene.ends.push_back(held("trunk", Kind::start));
  scene.ends.back().line = 17;
  EXPECT_NE(refusal([&] { assemble_rods(scene); }).find("fork.yaml:17: start of 'trunk'"),
            std::string::npos);
}

}  // namespace
}  // namespace vasorod
