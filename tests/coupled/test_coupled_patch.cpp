// The patch around a seam, in which the rest of the walls is held.
#include <cmath>
#include <gtest/gtest.h>

#include "coupled/joined_tubes.h"

namespace vasorod {
namespace {

using namespace testing;

constexpr int around = joined_around, along = joined_along;
constexpr double rounding = 1e-10;

class CoupledPatchTest : public ::testing::Test {
 protected:
  CoupledPatchTest() : stack_(joined_tubes(), {}), path_(stack_) { put_at_start(stack_, path_); }
  Points positions() const { return stack_.system->state(stack_.z).positions; }

  CoupledStack stack_;
  CoupledPath path_;
};

TEST_F(CoupledPatchTest, OnlyWhatIsNearTheSeamMoves) {
  const Points start = positions();
  const int whole = stack_.system->unknowns();
  ASSERT_TRUE(path_.narrow(Patch::seam_and_contacts));
  EXPECT_TRUE(stack_.is_narrow());
  EXPECT_LT(2 * stack_.system->unknowns(), whole);
  EXPECT_LT((positions() - start).norm(), rounding);
  stack_.z += 0.1 * Eigen::VectorXd::Ones(stack_.z.size());
  const Points moved = positions();
  const double reach = 2 * stack_.seam_radius, seam = stack_.scaled.bodies[1].rest.points(0, 2);
  const double edge = 2;  // mean edges; a way along edges is a little longer than a straight one
  int near = 0;
  for (Eigen::Index i = 0; i < start.rows(); ++i) {
    const bool moves = (moved.row(i) - start.row(i)).norm() > rounding;
    const bool aside = i >= 2 * around * (along + 1);
    near += moves ? 1 : 0;
    const double away = std::abs(start(i, 2) - seam);
    if (aside || away > reach + edge) {
      EXPECT_FALSE(moves) << i;
    } else if (away < reach / 1.2 - edge) {
      EXPECT_TRUE(moves) << i;
    }
  }
  EXPECT_GT(near, 2 * around);
  // The whole has what the patch found.
  path_.widen();
  EXPECT_FALSE(stack_.is_narrow());
  EXPECT_EQ(stack_.system->unknowns(), whole);
  EXPECT_LT((positions() - moved).norm(), rounding);
}

TEST_F(CoupledPatchTest, WhatTheStartExpectsToBePressedOnMoves) {
  stack_.problem.start->pressure[2][5 * around] = 1e-3;
  ASSERT_TRUE(path_.narrow(Patch::seam_and_contacts));
  const Points start = positions();
  stack_.z += 0.1 * Eigen::VectorXd::Ones(stack_.z.size());
  EXPECT_GT((positions() - start).bottomRows(around * (along + 1)).norm(), 0);
}

TEST_F(CoupledPatchTest, ThatOfTheSeamAloneIsSmallerAndHasNoContacts) {
  stack_.problem.start->pressure[2][5 * around] = 1e-3;
  ASSERT_TRUE(path_.narrow(Patch::seam));
  const Points start = positions();
  stack_.z += 0.1 * Eigen::VectorXd::Ones(stack_.z.size());
  const Points moved = positions();
  const double seam = stack_.scaled.bodies[1].rest.points(0, 2), edge = 2;
  int near = 0;
  for (Eigen::Index i = 0; i < start.rows(); ++i) {
    if ((moved.row(i) - start.row(i)).norm() <= rounding) continue;
    ++near;
    EXPECT_LT(i, 2 * around * (along + 1));
    EXPECT_LT(std::abs(start(i, 2) - seam), stack_.seam_radius + edge) << i;
  }
  EXPECT_GT(near, 2 * around);
}

TEST_F(CoupledPatchTest, ThePatchHasTheSeam) {
  const size_t joins = stack_.system->joins.size();
  const double k = stack_.system->k_j;
  ASSERT_TRUE(path_.narrow(Patch::seam_and_contacts));
  EXPECT_EQ(stack_.system->joins.size(), joins);
  EXPECT_EQ(stack_.system->k_j, k);
}

TEST(CoupledPatch, OneThatWouldHoldLittleIsNotMade) {
  const HeldTube half(12, 6, 0.6, around, 8);
  CoupledProblem problem;
  add_tube(problem, half, "lower", Vec3::Zero(), {half.start()});
  add_tube(problem, half, "upper", Vec3(0, 0, 12), {half.end()});
  for (const int v : half.row(0)) problem.surfaces.seams.push_back({1, v, 0, v + 8 * around});
  carry_by_sections(problem);
  CoupledStart& start = problem.start.emplace();
  for (const SurfaceBody& body : problem.surfaces.bodies) {
    start.bodies.emplace_back().points = body.rest.points;
    start.pressure.emplace_back();
  }
  CoupledStack stack(std::move(problem), {});
  CoupledPath path(stack);
  put_at_start(stack, path);
  const Eigen::VectorXd z = stack.z;
  EXPECT_FALSE(path.narrow(Patch::seam_and_contacts));
  EXPECT_FALSE(stack.is_narrow());
  EXPECT_EQ(stack.z, z);
}

}  // namespace
}  // namespace vasorod
