#include <Eigen/Eigenvalues>
#include <cmath>
#include <gtest/gtest.h>

#include "bodies/crossing_guard.h"
#include "bodies/hairpin.h"
#include "paper/paper_tubes.h"

namespace vasorod {
namespace {

using namespace testing;

constexpr double radius = 6, length = 60, reach = 0.4, stiffness = 3;
const TriangleSurface straight = tube(radius, length, 16, 24);

// Bent to a hairpin whose legs are `gap` apart.
Points bent_back(double gap) {
  return hairpin(straight.points, length, radius + gap / 2);
}

Eigen::MatrixXd hessian_of(CrossingGuard& guard, const Points& p, double blend) {
  std::vector<Eigen::Triplet<double>> entries;
  guard.hessian(p, blend, 0, entries);
  Eigen::SparseMatrix<double> matrix(p.size(), p.size());
  matrix.setFromTriplets(entries.begin(), entries.end());
  return Eigen::MatrixXd(matrix);
}

// With random waves, so that all kinds of features come near each other.
Points nearly_touching() {
  return bent_back(0.5) + random_points(static_cast<int>(straight.points.rows()), 5, 0.12);
}

TEST(CrossingGuard, IsExactlyZeroAtRestAndWhereNothingIsNear) {
  CrossingGuard guard(straight, reach, stiffness);
  EXPECT_EQ(guard.energy(straight.points), 0);
  EXPECT_EQ(guard.energy(bent_back(14)), 0);
  EXPECT_GT(guard.energy(nearly_touching()), 0);
}

TEST(CrossingGuard, ItsDerivativesAreThoseOfDifferences) {
  CrossingGuard guard(straight, reach, stiffness);
  const Points p = nearly_touching();
  const auto slope = [&](const Points& at) {
    Points gradient = Points::Zero(at.rows(), 3);
    EXPECT_NEAR(guard.gradient(at, gradient), guard.energy(at), 1e-14);
    return gradient;
  };
  const auto value = [&](const Points& at) { return guard.energy(at); };
  EXPECT_LT(gradient_error(value, p, slope(p), 1e-6), 1e-5);
  EXPECT_LT(hessian_error(slope, p, hessian_of(guard, p, 0), 1e-6), 1e-4);
}

TEST(CrossingGuard, ItsConvexPartIsConvexAndBelowItsBound) {
  CrossingGuard guard(straight, reach, stiffness);
  const Points p = nearly_touching();
  const Eigen::MatrixXd convex = hessian_of(guard, p, 1);
  std::vector<Eigen::Triplet<double>> entries;
  guard.bound(p, 0, entries);
  Eigen::SparseMatrix<double> bound(p.rows(), p.rows());
  bound.setFromTriplets(entries.begin(), entries.end());
  const double largest = convex.cwiseAbs().maxCoeff();
  const auto smallest = [](const Eigen::MatrixXd& m) {
    return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(m, Eigen::EigenvaluesOnly)
        .eigenvalues()
        .minCoeff();
  };
  EXPECT_GT(smallest(convex), -1e-12 * largest);
  EXPECT_GT(smallest(for_xyz(bound) - convex), -1e-12 * largest);
  const Eigen::MatrixXd half = hessian_of(guard, p, 0.5);
  EXPECT_LT((half - (convex + hessian_of(guard, p, 0)) / 2).cwiseAbs().maxCoeff(), 1e-12 * largest);
}

TEST(CrossingGuard, ARigidMotionChangesNothing) {
  CrossingGuard guard(straight, reach, stiffness);
  const Points p = nearly_touching();
  const Mat3 turn = random_rotations(1, 3)[0];
  const Points moved = (p * turn.transpose()).rowwise() + Eigen::RowVector3d(3, -5, 40);
  EXPECT_NEAR(guard.energy(moved), guard.energy(p), 1e-9 * guard.energy(p));
  Points here = Points::Zero(p.rows(), 3), there = here;
  guard.gradient(p, here);
  guard.gradient(moved, there);
  EXPECT_LT((here * turn.transpose() - there).cwiseAbs().maxCoeff(),
            1e-8 * here.cwiseAbs().maxCoeff());
  EXPECT_LT(here.colwise().sum().norm(), 1e-12 * here.norm());
}

// Two flat pieces of one surface, `apart` from each other.
TriangleSurface pieces(double apart) {
  TriangleSurface s;
  s.points.resize(6, 3);
  s.points << 0, 0, 0, 4, 0, 0, 0, 4, 0, 1, 1, apart, 3, 0.5, apart, 0.5, 3, apart;
  s.triangles.resize(2, 3);
  s.triangles << 0, 1, 2, 3, 5, 4;
  return s;
}

TEST(CrossingGuard, AStepLeavesATenthOfTheDistance) {
  const TriangleSurface apart = pieces(1);
  CrossingGuard guard(apart, 0.05, 1);
  const auto down = [&](double by) {
    Points to = apart.points;
    to.bottomRows(3).col(2).array() -= by;
    return to;
  };
  EXPECT_EQ(guard.longest_step(apart.points, down(0.5)), 1);
  EXPECT_EQ(guard.longest_step(apart.points, down(-1)), 1);
  for (const double by : {1.0, 2.0, 100.0}) {
    const double share = guard.longest_step(apart.points, down(by));
    EXPECT_LE(share * by, 0.9) << by;
    EXPECT_GE(share * by, 0.88) << by;
  }
}

// An edge that passes an edge, while no vertex comes near a triangle.
TEST(CrossingGuard, EdgesDoNotPassThroughEdges) {
  TriangleSurface s;
  s.points.resize(6, 3);
  s.points << -2, 0, 0, 2, 0, 0, 0, 0, -3, 0, -2, 1, 0, 2, 1, 0, 0, 4;
  s.triangles.resize(2, 3);
  s.triangles << 0, 1, 2, 3, 4, 5;
  CrossingGuard guard(s, 0.05, 1);
  Points to = s.points;
  to.bottomRows(3).col(2).array() -= 1.5;
  const double share = guard.longest_step(s.points, to);
  EXPECT_LE(1.5 * share, 0.9);
  EXPECT_GE(1.5 * share, 0.88);
}

TEST(CrossingGuard, WhatIsNearAtRestIsLeftOut) {
  const TriangleSurface near = pieces(0.06);
  CrossingGuard guard(near, 0.05, 1);
  Points to = near.points;
  to.bottomRows(3).col(2).array() -= 0.05;
  EXPECT_EQ(guard.energy(to), 0);
  EXPECT_EQ(guard.longest_step(near.points, to), 1);
}

}  // namespace
}  // namespace vasorod
