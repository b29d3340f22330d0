#include <gtest/gtest.h>

#include "numerics/kept_factor.h"
#include "paper/paper_stack.h"
#include "paper/paper_tubes.h"

namespace vasorod {
namespace {

using namespace testing;

constexpr int around = 12, along = 6;

// An obstacle, a tube that its rod moves, and one that stays.
struct Stack {
  BodyProblem problem;
  PaperOptions options;
  Work work;
  KeptFactor bound{&work};
  std::unique_ptr<PaperStack> stack;
  explicit Stack(bool touches_itself) {
    for (int b = 0; b < 3; ++b) {
      SurfaceBody body;
      body.name = "body " + std::to_string(b);
      body.rest = tube(5, 20, around, along);
      body.rest.points.col(0).array() += 30 * b;
      body.k = {0.1, 1, 0.3};
      body.obstacle = b == 0;
      body.fixed.assign(static_cast<size_t>(body.rest.points.rows()), 0);
      body.fixed[0] = 1;
      problem.bodies.push_back(body);
    }
    problem.bodies[1].carried = problem.bodies[1].rest.points.rowwise() + shift;
    if (touches_itself) problem.contacts = {{1, 1}};
    stack = std::make_unique<PaperStack>(problem, options, bound, work);
  }
  Points at(size_t body) const { return stack->scaled.unscaled(stack->scaled.bodies[body].now); }
  static inline const Eigen::RowVector3d shift{0, 0, 4};
};

TEST(PaperStack, WhatIsMovedIsModelledUntilMoreIsTouched) {
  Stack made(false);
  PaperStack& stack = *made.stack;
  ASSERT_TRUE(stack.any_modelled());
  stack.build();
  EXPECT_EQ(stack.first, (std::vector<int>{-1, 0, -1}));
  const Points moved = stack.positions;
  stack.add({2});
  EXPECT_EQ(stack.first, (std::vector<int>{-1, 0, static_cast<int>(moved.rows())}));
  EXPECT_EQ(stack.positions.topRows(moved.rows()), moved);
}

TEST(PaperStack, AWayMovesTheRodsPositionsAndWhatIsFixedToThem) {
  Stack made(false);
  PaperStack& stack = *made.stack;
  const Points rest = made.problem.bodies[1].rest.points;
  stack.put_at_rest();
  stack.build();
  EXPECT_LT((made.at(1) - rest).norm(), 1e-12 * rest.norm());
  std::vector<CarriedBody> half(3);
  half[1].points = rest.rowwise() + Stack::shift / 2;
  stack.carry(half);
  const Points carried = stack.scaled.unscaled(stack.system.carried);
  EXPECT_LT((carried - half[1].points).norm(), 1e-12 * rest.norm());
  stack.unstack();
  EXPECT_LT((made.at(1).row(0) - half[1].points.row(0)).norm(), 1e-12 * rest.norm());
  EXPECT_LT((made.at(1).bottomRows(5) - rest.bottomRows(5)).norm(), 1e-12 * rest.norm());
}

TEST(PaperStack, OnlyWhatMayTouchItselfIsGuarded) {
  for (const bool guarded : {false, true}) {
    Stack made(guarded);
    made.stack->build();
    EXPECT_EQ(made.stack->system.guarded(), guarded);
  }
}

}  // namespace
}  // namespace vasorod
