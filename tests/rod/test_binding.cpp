#include <gtest/gtest.h>
#include <random>

#include <vasorod/error.h>

#include "geometry/rigid_motion.h"
#include "rod/binding.h"

namespace vasorod {
namespace {

// A helical rod: its strain is constant, so every section's frame is known in closed form.
RodTree helix(int elements, double length, const Vec3& curvature) {
  RodTree tree;
  Pose start;
  start.rotation = exp_rotation(Vec3(0.4, -0.2, 0.9));
  start.position = Vec3(3, -5, 7);
  Vec6 strain;
  strain << 0, 0, 1, curvature;
  RodBranch branch;
  for (int k = 0; k <= elements; ++k) {
    tree.rest.push_back(start * exp_motion(strain * (length * k / elements)));
    branch.nodes.push_back(k);
    if (k == elements) break;
    RodElement e;
    e.first = k;
    e.second = k + 1;
    e.length = length / elements;
    e.rest_strain = e.natural_strain = strain;
    tree.elements.push_back(e);
    branch.elements.push_back(k);
  }
  tree.branches.push_back(branch);
  return tree;
}

Pose helix_frame(const RodTree& tree, double s) {
  return tree.rest[0] * exp_motion(tree.elements[0].rest_strain * s);
}

TEST(Binding, FindsTheSectionThroughEachPoint) {
  const double length = 60;
  const RodTree tree = helix(17, length, Vec3(0.02, 0.03, 0.05));
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> along(0, length), across(-9, 9);
  const int n = 500;
  std::vector<double> s(n);
  Points points(n, 3), local(n, 3);
  for (int i = 0; i < n; ++i) {
    s[static_cast<size_t>(i)] = along(generator);
    local.row(i) << across(generator), across(generator), 0;
    points.row(i) = helix_frame(tree, s[static_cast<size_t>(i)]) * Vec3(local.row(i));
  }
  const Binding binding = vasorod::bind(tree, points, {});
  for (int i = 0; i < n; ++i) {
    const RodCoordinates& at = binding[static_cast<size_t>(i)];
    EXPECT_NEAR(at.element * length / 17 + at.s, s[static_cast<size_t>(i)], 1e-10);
    EXPECT_NEAR((at.local - Vec3(local.row(i))).norm(), 0, 1e-10);
    EXPECT_EQ(at.local.z(), 0);
  }
  EXPECT_LT((carried_points(tree, tree.rest, binding) - points).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(Binding, PointsBeyondTheEndsKeepTheirPlaceByZ) {
  const RodTree tree = helix(8, 20, Vec3(0, 0.02, 0));
  Points points(2, 3);
  points.row(0) = tree.rest.front() * Vec3(1, 2, -3);
  points.row(1) = tree.rest.back() * Vec3(-2, 1, 4);
  const Binding binding = vasorod::bind(tree, points, {});
  EXPECT_NEAR((binding[0].local - Vec3(1, 2, -3)).norm(), 0, 1e-13);
  EXPECT_NEAR((binding[1].local - Vec3(-2, 1, 4)).norm(), 0, 1e-13);
  EXPECT_EQ(binding[1].element, 7);
  EXPECT_LT((carried_points(tree, tree.rest, binding) - points).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(Binding, SectionsReachingTheCentreOfCurvatureAreRefused) {
  const RodTree tree = helix(16, 40, Vec3(0, 0.1, 0));  // bends about a centre 10 away along +d1
  Points points(1, 3);
  points.row(0) = helix_frame(tree, 20) * Vec3(9, 0, 0);
  EXPECT_NO_THROW(vasorod::bind(tree, points, {}));
  points.row(0) = helix_frame(tree, 20) * Vec3(9.9, 0, 0);
  EXPECT_THROW(vasorod::bind(tree, points, {}), InputError);
}

TEST(Binding, CarriesSectionsRigidlyWithAnyPose) {
  const RodTree tree = helix(6, 30, Vec3(0.01, 0, 0.03));
  RodPoses poses = tree.rest;
  for (size_t k = 0; k < poses.size(); ++k) {  // adds bending, stretch and twist
    Vec6 twist;
    twist << 0.3 * static_cast<double>(k), -0.1, 0.4, 0.05 * static_cast<double>(k), 0.02, -0.1;
    poses[k] = exp_motion(twist) * poses[k];
  }
  std::mt19937 generator(4);
  std::uniform_real_distribution<double> along(0, 30), angle(-M_PI, M_PI);
  for (int ring = 0; ring < 20; ++ring) {
    const double s = along(generator);
    Points points(6, 3);
    for (int i = 0; i < 6; ++i) {
      const double a = angle(generator);
      points.row(i) = helix_frame(tree, s) * Vec3(4 * std::cos(a), 4 * std::sin(a), 0);
    }
    const Binding binding = vasorod::bind(tree, points, {});
    const Points carried = carried_points(tree, poses, binding);
    const std::vector<Mat3> rotations = carried_rotations(tree, poses, binding);
    const Pose before = frame_at(tree, tree.rest, binding[0].element, binding[0].s);
    const Pose after = frame_at(tree, poses, binding[0].element, binding[0].s);
    EXPECT_NEAR((before.position - helix_frame(tree, s).position).norm(), 0, 1e-11);
    for (int i = 0; i < 6; ++i) {
      const Vec3 arm = rotations[static_cast<size_t>(i)] * (Vec3(points.row(i)) - before.position);
      EXPECT_NEAR((Vec3(carried.row(i)) - after.position - arm).norm(), 0, 1e-10);
    }
  }
}

TEST(Binding, ASecondLimbNearbyDoesNotAttract) {
  const RodTree tree = helix(40, 60, Vec3(0, M_PI / 60, 0));  // half a circle of radius 19.1
  Points points(2, 3);
  points.row(0) = helix_frame(tree, 5) * Vec3(12, 0, 0);
  points.row(1) = helix_frame(tree, 55) * Vec3(12, 0, 0);
  const Binding binding = vasorod::bind(tree, points, {});
  EXPECT_NEAR(binding[0].element * 1.5 + binding[0].s, 5, 1e-10);
  EXPECT_NEAR(binding[1].element * 1.5 + binding[1].s, 55, 1e-10);
}

TEST(Binding, BranchesRestrictTheSearch) {
  RodTree tree = helix(4, 8, Vec3::Zero());
  RodBranch second;  // from the last node of the first, at a right angle
  second.parent = 0;
  second.nodes = {4, 5};
  second.elements = {4};
  RodElement e;
  e.first = 4;
  e.second = 5;
  e.length = 8;
  Pose turn;
  turn.rotation = exp_rotation(Vec3(0, M_PI / 2, 0));
  turn.position = Vec3(8, 0, 0);
  tree.rest.push_back(tree.rest[4] * turn);
  e.rest_strain = e.natural_strain = log_motion(turn) / 8;
  tree.elements.push_back(e);
  tree.branches.push_back(second);
  Points points(1, 3);
  points.row(0) = tree.rest[2] * Vec3(1, 0, 0.5);
  EXPECT_EQ(vasorod::bind(tree, points, {0})[0].element, 2);
  EXPECT_EQ(vasorod::bind(tree, points, {1})[0].element, 4);
  EXPECT_EQ(project(tree, points.row(0)).element, 2);
}

}  // namespace
}  // namespace vasorod
