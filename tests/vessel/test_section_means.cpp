#include <gtest/gtest.h>

#include "geometry/rigid_motion.h"
#include "infant_anatomy.h"
#include "rod/strain_change.h"
#include "straight_tube.h"
#include "vessel/section_means.h"

namespace vasorod {
namespace {

Vessel fitted_tube() {
  return fit_vessel("tube", tube_surface(testing::straight_tube(60, 6, 32, 48)));
}

// Poses of a rod whose strain changes by a smooth field along the axis.
RodPoses deformed(const RodTree& rod, double size) {
  RodPoses poses = rod.rest;
  double s = 0;
  for (const RodElement& e : rod.elements) {
    Vec6 strain = e.rest_strain;
    strain[2] += 0.3 * size;
    strain[4] += size * 0.05 * std::sin(M_PI * (s + e.length / 2) / 60);
    strain[5] += size * 0.03;
    poses[static_cast<size_t>(e.second)] =
        poses[static_cast<size_t>(e.first)] * exp_motion(e.length * strain);
    s += e.length;
  }
  return poses;
}

TEST(SectionMeans, ARodIsFoundAgainInTheSurfaceItCarries) {
  const Vessel vessel = fitted_tube();
  const RodPoses exact = deformed(vessel.rod, 0.2);
  const Points carried = carried_points(vessel.rod, exact, vessel.binding);
  // Exact from the poses themselves; from neighbouring poses, second order in the change of the
  // difference along a band.
  for (const double other : {0.2, 0.19}) {
    const RodPoses found = section_means(vessel, carried, deformed(vessel.rod, other), {});
    for (size_t n = 0; n < exact.size(); ++n) {
      const double tolerance = other == 0.2 ? 1e-9 : 2e-3;
      EXPECT_LT((found[n].position - exact[n].position).norm(), tolerance * 6) << n;
      EXPECT_LT((found[n].rotation - exact[n].rotation).norm(), tolerance) << n;
    }
  }
}

TEST(SectionMeans, AFlatteningLeavesTheAxisWhereItIs) {
  const Vessel vessel = fitted_tube();
  Points flat = vessel.surface.points;
  flat.col(0) *= 0.8;
  flat.col(1) *= 1.15;
  const RodPoses found = section_means(vessel, flat, vessel.rod.rest, {});
  for (size_t n = 0; n < found.size(); ++n) {
    EXPECT_LT((found[n].position - vessel.rod.rest[n].position).norm(), 1e-3 * 6);
    EXPECT_LT((found[n].rotation - vessel.rod.rest[n].rotation).norm(), 2e-3);
  }
}

TEST(SectionMeans, WhatIsKnownIsTakenAndWhatIsUnseenFollowsItsNeighbour) {
  const Vessel vessel = fitted_tube();
  const size_t n = vessel.rod.rest.size();
  std::vector<std::optional<Pose>> known(n);
  known[0] = Pose{exp_rotation(Vec3(0.1, 0, 0)), Vec3(1, 2, 3)};
  std::vector<char> unseen(n, 0);
  unseen[n - 1] = 1;
  const Vec3 shift(3, -1, 2);
  const Points moved = vessel.surface.points.rowwise() + shift.transpose();
  const RodPoses found = section_means(vessel, moved, vessel.rod.rest, known, unseen);
  EXPECT_EQ(found[0].position, known[0]->position);
  EXPECT_LT((found[n - 1].position - vessel.rod.rest[n - 1].position - shift).norm(), 1e-9);
}

// A known end is what the nodes before it lead to where their sections are not seen. The band of
// the last seen section reaches into the wall that stayed behind, so that its node lags a little.
TEST(SectionMeans, UnseenNodesLeadToAKnownEnd) {
  const Vessel vessel = fitted_tube();
  const RodPoses& rest = vessel.rod.rest;
  const size_t n = rest.size(), hidden = 5;
  std::vector<std::optional<Pose>> known(n);
  known[n - 1] = rest[n - 1];
  known[n - 1]->position.z() += 0.6;
  std::vector<char> unseen(n, 0);
  for (size_t k = n - hidden; k < n; ++k) unseen[k] = 1;
  const RodPoses found = section_means(vessel, vessel.surface.points, rest, known, unseen);
  const auto lengthened = [&](size_t k) {
    return (found[k].position - found[k - 1].position).norm() -
           (rest[k].position - rest[k - 1].position).norm();
  };
  EXPECT_NEAR(lengthened(n - hidden - 1), 0, 0.02);
  for (size_t k = n - hidden; k < n; ++k) EXPECT_NEAR(lengthened(k), 0.6 / hidden, 0.02) << k;
}

// A map of space: stretched along z, twisted about z and bent in the plane of x and z.
Vec3 mapped(const Vec3& p, double stretch, double twist, double curvature) {
  const double angle = twist * p.z(), x = std::cos(angle) * p.x() - std::sin(angle) * p.y(),
               y = std::sin(angle) * p.x() + std::cos(angle) * p.y(), z = stretch * p.z();
  const double turn = curvature * z, out = 1 / curvature - x;
  return {1 / curvature - out * std::cos(turn), y, out * std::sin(turn)};
}

// The axis of a forked vessel follows its wall: nowhere does it stretch or shrink more than any
// edge of the wall, bend or twist more than the map. One fork, and three.
TEST(SectionMeans, BesideForksTheAxisFollowsTheWall) {
  for (const char* name : {"pulmonary_artery", "aorta"}) {
    const Vessel vessel = fit_vessel(name, testing::infant(name));
    ASSERT_GT(vessel.rod.branches.size(), 1U);
    const Vec3 middle = vessel.surface.points.colwise().mean();
    Points current(vessel.surface.points.rows(), 3);
    for (Eigen::Index i = 0; i < current.rows(); ++i)
      current.row(i) = mapped(Vec3(vessel.surface.points.row(i)) - middle, 1.04, 0.004, 0.004);
    double shortest = 1, longest = 1;
    for (Eigen::Index t = 0; t < vessel.surface.triangles.rows(); ++t)
      for (int k = 0; k < 3; ++k) {
        const int a = vessel.surface.triangles(t, k), b = vessel.surface.triangles(t, (k + 1) % 3);
        const double ratio = (current.row(a) - current.row(b)).norm() /
                             (vessel.surface.points.row(a) - vessel.surface.points.row(b)).norm();
        shortest = std::min(shortest, ratio);
        longest = std::max(longest, ratio);
      }
    const RodPoses found = section_means(vessel, current, vessel.rod.rest, {});
    for (const ElementChange& element : element_changes(vessel.rod, found)) {
      const double stretch =
          element.strain.head<3>().norm() / (element.strain - element.change).head<3>().norm();
      EXPECT_GT(stretch, shortest - 0.01) << name << " at " << element.rest_middle.transpose();
      EXPECT_LT(stretch, longest + 0.01) << name << " at " << element.rest_middle.transpose();
      // The map bends and twists by 0.004 each.
      EXPECT_LT(element.bending() * element.radius, 0.008 * element.radius + 0.01)
          << name << " at " << element.rest_middle.transpose();
      EXPECT_LT(std::abs(element.twist()) * element.radius, 0.008 * element.radius + 0.01)
          << name << " at " << element.rest_middle.transpose();
    }
  }
}

}  // namespace
}  // namespace vasorod
