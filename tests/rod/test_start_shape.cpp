#include <gtest/gtest.h>
#include <numbers>

#include "geometry/rigid_motion.h"
#include "rod/start_shape.h"

namespace vasorod {
namespace {

// Nodes along z at unequal distances; node k + 1 hangs on node k.
struct Line {
  std::vector<double> s{0, 1, 3, 4, 8, 10};
  std::vector<RodLink> links;
  std::vector<Pose> poses;
  Line() {
    for (size_t k = 0; k < s.size(); ++k) {
      poses.push_back({Mat3::Identity(), Vec3(0, 0, s[k])});
      if (k == 0) continue;
      RodLink link;
      link.parent = static_cast<int>(k) - 1;
      link.length = s[k] - s[k - 1];
      links.push_back(link);
    }
  }
};

NodeCondition held(int node, const Pose& target) {
  NodeCondition condition;
  condition.node = node;
  condition.fixed.fill(true);
  condition.target = target;
  return condition;
}

TEST(StartShape, ATurnIsSpreadLinearlyAlongARod) {
  const Line line;
  const Vec3 turn(0, 0, 5 * std::numbers::pi);  // two turns and a half
  const std::vector<NodeCondition> conditions{
      held(0, line.poses[0]), held(5, {exp_rotation(turn), line.poses[5].position})};
  double largest = 0;
  const std::vector<Pose> shape =
      start_shape(line.links, conditions, {Vec3::Zero(), turn}, line.poses, &largest);
  for (size_t k = 0; k < shape.size(); ++k) {
    EXPECT_LT((shape[k].rotation - exp_rotation(turn * line.s[k] / 10)).norm(), 1e-12) << k;
    EXPECT_LT((shape[k].position - line.poses[k].position).norm(), 1e-12) << k;
  }
  EXPECT_NEAR(largest, 0.4 * turn.norm(), 1e-12) << "of the longest link";
}

TEST(StartShape, APushIsSpreadLinearlyToo) {
  const Line line;
  const Vec3 push(1, 0, -2);
  const std::vector<NodeCondition> conditions{
      held(0, line.poses[0]), held(5, {Mat3::Identity(), line.poses[5].position + push})};
  const std::vector<Pose> shape =
      start_shape(line.links, conditions, {Vec3::Zero(), Vec3::Zero()}, line.poses);
  for (size_t k = 0; k < shape.size(); ++k)
    EXPECT_LT((shape[k].position - line.poses[k].position - push * line.s[k] / 10).norm(), 1e-12);
}

TEST(StartShape, WhatIsHeldAtOneEndMovesRigidly) {
  const Line line;
  const Vec3 turn(0.4, -0.7, 0.2), shift(3, 1, -2);
  const std::vector<NodeCondition> conditions{held(2, {exp_rotation(turn), Vec3(0, 0, 3) + shift})};
  const std::vector<Pose> shape = start_shape(line.links, conditions, {turn}, line.poses);
  for (size_t k = 0; k < shape.size(); ++k) {
    const Vec3 arm(0, 0, line.s[k] - 3);
    EXPECT_LT((shape[k].rotation - exp_rotation(turn)).norm(), 1e-13);
    EXPECT_LT((shape[k].position - exp_rotation(turn) * arm - Vec3(0, 0, 3) - shift).norm(), 1e-12);
  }
}

// Three arms of lengths 1, 2 and 4 from one node, their tips turned: the fork's turn is the mean by
// conductance, as in an electric circuit.
TEST(StartShape, AForkTakesTheMeanByConductance) {
  std::vector<RodLink> links(3);
  std::vector<Pose> poses(4);
  const double lengths[] = {1, 2, 4};
  const Vec3 axis(0.01, 0.02, -0.01);
  const double turns[] = {1, -2, 5};
  std::vector<NodeCondition> conditions;
  std::vector<Vec3> turn;
  double sum = 0, weight = 0;
  for (size_t k = 0; k < 3; ++k) {
    links[k].length = lengths[k];
    poses[k + 1].position = lengths[k] * Vec3::Unit(static_cast<int>(k));
    turn.push_back(turns[k] * axis);
    conditions.push_back(
        held(static_cast<int>(k) + 1, {exp_rotation(turn.back()), poses[k + 1].position}));
    sum += turns[k] / lengths[k];
    weight += 1 / lengths[k];
  }
  const std::vector<Pose> shape = start_shape(links, conditions, turn, poses);
  EXPECT_LT((log_rotation(shape[0].rotation) - sum / weight * axis).norm(), 1e-13);
}

TEST(StartShape, WithoutConditionsNothingMoves) {
  const Line line;
  const std::vector<Pose> shape = start_shape(line.links, {}, {}, line.poses);
  for (size_t k = 0; k < shape.size(); ++k) EXPECT_EQ(shape[k].position, line.poses[k].position);
}

}  // namespace
}  // namespace vasorod
