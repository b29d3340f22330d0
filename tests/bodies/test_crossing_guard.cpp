#include <Eigen/Eigenvalues>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>

#include "bodies/crossing_guard.h"
#include "bodies/hairpin.h"
#include "geometry/rigid_motion.h"
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

// Two square sheets of one surface, the second above the first by `apart` and turned a little.
// Their normals show at each other, or away from it.
TriangleSurface sheets(double apart, bool at_each_other) {
  constexpr int across = 4;
  TriangleSurface s;
  s.points.resize(2 * across * across, 3);
  s.triangles.resize(4 * (across - 1) * (across - 1), 3);
  const Mat3 turn = exp_rotation(Vec3(0.02, -0.03, 0.4));
  Eigen::Index t = 0;
  for (int sheet = 0; sheet < 2; ++sheet)
    for (int i = 0; i < across; ++i)
      for (int j = 0; j < across; ++j) {
        const int v = (sheet * across + i) * across + j;
        const Vec3 flat(i - 1.5, j - 1.5, 0);
        s.points.row(v) = sheet == 0 ? flat : Vec3(turn * flat + Vec3(0.1, 0.2, apart));
        if (i + 1 == across || j + 1 == across) continue;
        const bool up = (sheet == 0) == at_each_other;
        for (const auto& [b, c] : {std::pair{v + across, v + across + 1}, {v + across + 1, v + 1}})
          s.triangles.row(t++) << v, (up ? b : c), (up ? c : b);
      }
  return s;
}

// Its faces lie .3 inside the surface and .8 outside.
constexpr GuardedWall wall{0.3, 0.8, 8};
constexpr double narrow = 0.1;

TEST(CrossingGuard, WhatIsFarAlongAWallMeetsWithItsFaces) {
  for (const bool outside : {false, true}) {
    const double faces = outside ? 1.6 : 0.6;
    const auto at = [&](double apart) { return sheets(apart, outside).points; };
    CrossingGuard guard(sheets(3, outside), narrow, stiffness, wall);
    EXPECT_EQ(guard.energy(at(2)), 0);  // which faces meet is seen before they do
    EXPECT_EQ(guard.energy(at(faces + 0.25)), 0);
    EXPECT_GT(guard.energy(at(faces + 0.12)), 0);
    EXPECT_EQ(guard.smallest_gap(at(30)), std::numeric_limits<double>::infinity());
    EXPECT_EQ(guard.energy(at(2)), 0);
    const double gap = guard.smallest_gap(at(faces + 0.2));
    EXPECT_GT(gap, 0.08);  // the upper one is turned
    EXPECT_LT(gap, 0.2);
    EXPECT_LT(guard.longest_step(at(faces + 0.2), at(faces - 0.8)), 0.2);
  }
}

TEST(CrossingGuard, ItsDerivativesAreThoseOfDifferencesBetweenFaces) {
  CrossingGuard guard(sheets(3, true), narrow, stiffness, wall);
  guard.energy(sheets(2, true).points);
  const Points p = sheets(1.7, true).points;
  const auto slope = [&](const Points& at) {
    Points gradient = Points::Zero(at.rows(), 3);
    guard.gradient(at, gradient);
    return gradient;
  };
  EXPECT_GT(guard.energy(p), 0);
  EXPECT_LT(gradient_error([&](const Points& at) { return guard.energy(at); }, p, slope(p), 1e-6),
            1e-5);
  EXPECT_LT(hessian_error(slope, p, hessian_of(guard, p, 0), 1e-6), 1e-4);
}

TEST(CrossingGuard, ItGoesOnFromWhatItRemembers) {
  const auto at = [](double apart) { return sheets(apart, true).points; };
  CrossingGuard guard(sheets(3, true), narrow, stiffness, wall);
  guard.energy(at(2));
  const double near = guard.energy(at(1.72));
  EXPECT_GT(near, 0);
  const CrossingGuard::Memory memory = guard.memory();
  guard.energy(at(30));  // all is forgotten
  EXPECT_EQ(guard.energy(at(1.5)), 0) << "found within each other's walls";
  guard.remember(memory);
  EXPECT_EQ(guard.energy(at(1.72)), near);
}

// A guard that has followed the end of one leg away and back has found what one finds that looks at
// all of the surface; the rest of the legs touch all the while.
TEST(CrossingGuard, WhatMovesIsFoundAsIfAllWereSearched) {
  const Points touching = nearly_touching();
  const auto at = [&](double away) {
    Points p = touching;
    for (Eigen::Index i = 0; i < p.rows(); ++i)
      if (straight.points(i, 2) > 0.85 * length) p.row(i) += away * Eigen::RowVector3d(0, 1, 0.3);
    return p;
  };
  CrossingGuard following(straight, reach, stiffness);
  for (const double away : {0.0, 0.3, 1.5, 4.0, 9.0, 5.0, 1.2, 0.4, 0.0}) {
    const Points p = at(away);
    CrossingGuard fresh(straight, reach, stiffness);
    Points followed = Points::Zero(p.rows(), 3), found = followed;
    const double energy = fresh.gradient(p, found);
    EXPECT_GT(energy, 0) << away;
    EXPECT_NEAR(following.gradient(p, followed), energy, 1e-12 * energy) << away;
    EXPECT_LE((followed - found).norm(), 1e-12 * found.norm()) << away;
  }
}

// Steps towards another place, each as long as the guard allows, come to no place where faces lie
// in each other.
TEST(CrossingGuard, StepsNeverLeadThroughFaces) {
  CrossingGuard guard(sheets(3, true), narrow, stiffness, wall);
  Points p = sheets(3, true).points;
  EXPECT_EQ(guard.energy(p), 0);
  for (int step = 0; step < 14; ++step) {
    // The upper sheet comes down, a corner of it faster.
    Points to = p;
    for (Eigen::Index i = p.rows() / 2; i < p.rows(); ++i)
      to(i, 2) -= 0.06 + (i + 1 == p.rows() ? 0.25 : 0.0);
    p += guard.longest_step(p, to) * (to - p);
    EXPECT_TRUE(std::isfinite(guard.energy(p))) << step;
  }
  EXPECT_GT(guard.energy(p), 0);
}

// As the lips of a slit.
TEST(CrossingGuard, WallsThatLieInEachOtherAtFirstOnlyKeepTheirSurfacesApart) {
  CrossingGuard guard(sheets(1, true), narrow, stiffness, wall);
  EXPECT_EQ(guard.energy(sheets(1, true).points), 0);
  EXPECT_GT(guard.energy(sheets(0.08, true).points), 0);
}

}  // namespace
}  // namespace vasorod
