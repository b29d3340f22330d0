#include <gtest/gtest.h>
#include <random>

#include "coupled/held_section.h"
#include "geometry/rigid_motion.h"

namespace vasorod {
namespace {

using Fixed = std::array<bool, 6>;

// A section somewhere, in a frame of its own, moved and loaded.
HeldSection some_section(const Fixed& fixed) {
  HeldSection section;
  section.rest = {exp_rotation(Vec3(0.4, -0.3, 0.8)), Vec3(3, -2, 7)};
  section.fixed = fixed;
  section.frame = exp_rotation(Vec3(-0.2, 0.6, 0.1));
  section.motion = {Vec3(0.3, 0.2, -0.5), Vec3(1, 2, -1)};
  section.force = Vec3(0.5, -0.2, 0.3);
  section.moment = Vec3(0.1, 0.4, -0.3);
  section.body_moment = Vec3(-0.2, 0.3, 0.6);
  return section;
}

const Fixed all_fixed{1, 1, 1, 1, 1, 1}, none{}, two_turns{1, 0, 1, 0, 1, 0},
    spin{1, 1, 1, 1, 1, 0};

std::vector<double> some_unknowns(int count, double size = 0.7) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(-size, size);
  std::vector<double> z(static_cast<size_t>(std::max(count, 1)));
  for (double& value : z) value = uniform(random);
  return z;
}

TEST(SectionPose, FixedAltogetherItFollowsItsMotion) {
  const HeldSection section = some_section(all_fixed);
  SectionPose pose(section);
  EXPECT_EQ(pose.unknowns(), 0);
  for (const double t : {0.0, 0.4, 1.0}) {
    pose.set_time(t);
    const SectionPlacement at = pose.place(nullptr);
    EXPECT_LT((at.position - (section.rest.position + t * section.motion.move)).norm(), 1e-15);
    EXPECT_LT((at.rotation - exp_rotation(t * section.motion.rotate)).norm(), 1e-15);
  }
  const Pose other{exp_rotation(Vec3(1, 0, 0)), Vec3(9, 9, 9)};
  pose.set_target(other);
  EXPECT_EQ(pose.place(nullptr).position, other.position);
  EXPECT_LT((pose.place(nullptr).rotation - other.rotation).norm(), 1e-15);
}

TEST(SectionPose, FreeAxesAreThoseOfTheFrame) {
  const HeldSection section = some_section(two_turns);
  SectionPose pose(section);
  ASSERT_EQ(pose.unknowns(), 3);  // y, rx, rz
  pose.set_time(1);
  const std::vector<double> z{0.5, 0.2, -0.3};
  const SectionPlacement at = pose.place(z.data());
  const Mat3& frame = *section.frame;
  EXPECT_LT((at.position - section.rest.position - section.motion.move - 0.5 * frame.col(1)).norm(),
            1e-14);
  EXPECT_LT((at.rotation - exp_rotation(0.2 * frame.col(0) - 0.3 * frame.col(2)) *
                               exp_rotation(section.motion.rotate))
                .norm(),
            1e-14);
}

TEST(SectionPose, AxesAreTheDerivativesOfThePlacement) {
  for (const Fixed& fixed : {none, two_turns, spin}) {
    SectionPose pose(some_section(fixed));
    pose.set_time(0.6);
    const std::vector<double> z = some_unknowns(pose.unknowns());
    const SectionPlacement at = pose.place(z.data());
    const double h = 1e-6;
    for (int k = 0; k < pose.unknowns(); ++k) {
      std::vector<double> plus = z, minus = z;
      plus[static_cast<size_t>(k)] += h;
      minus[static_cast<size_t>(k)] -= h;
      const SectionPlacement a = pose.place(plus.data()), b = pose.place(minus.data());
      EXPECT_LT(((a.position - b.position) / (2 * h) - at.position_axes.col(k)).norm(), 1e-9);
      const Vec3 turn = log_rotation(a.rotation * b.rotation.transpose()) / (2 * h);
      EXPECT_LT((turn - at.rotation_axes.col(k)).norm(), 1e-9);
    }
  }
}

TEST(SectionPose, CurvatureIsTheSecondDerivativeOfArmsThatTurn) {
  const Vec3 arms[] = {{1, 2, -0.5}, {-0.7, 0.3, 1}}, forces[] = {{0.4, -1, 0.2}, {0.3, 0.8, -0.6}};
  for (const Fixed& fixed : {none, two_turns, spin}) {
    SectionPose pose(some_section(fixed));
    pose.set_time(1);
    const std::vector<double> z = some_unknowns(pose.unknowns());
    const auto value = [&](const std::vector<double>& at) {
      const Mat3 rotation = pose.place(at.data()).rotation;
      return forces[0].dot(rotation * arms[0]) + forces[1].dot(rotation * arms[1]);
    };
    const SectionPlacement at = pose.place(z.data());
    Vec3 torque = Vec3::Zero();
    Mat3 spread = Mat3::Zero();
    for (int i = 0; i < 2; ++i) {
      const Vec3 a = at.rotation * arms[i];
      torque += a.cross(forces[i]);
      spread += a * forces[i].transpose() - a.dot(forces[i]) * Mat3::Identity();
    }
    const Mat6 curvature = pose.curvature(at, torque, spread);
    const double h = 1e-4;
    for (int i = 0; i < pose.unknowns(); ++i)
      for (int j = 0; j < pose.unknowns(); ++j) {
        const auto shifted = [&](double a, double b) {
          std::vector<double> moved = z;
          moved[static_cast<size_t>(i)] += a;
          moved[static_cast<size_t>(j)] += b;
          return value(moved);
        };
        const double exact =
            (shifted(h, h) - shifted(h, -h) - shifted(-h, h) + shifted(-h, -h)) / (4 * h * h);
        EXPECT_NEAR(curvature(i, j), exact, 1e-6) << i << ' ' << j;
      }
  }
}

TEST(SectionPose, UnknownsOfAPoseBringItBack) {
  SectionPose pose(some_section(none));
  pose.set_time(0.5);
  const Mat3 rotation = exp_rotation(Vec3(1.2, -0.9, 0.4));
  const Vec3 position(5, 6, 7);
  std::vector<double> z(6);
  pose.unknowns_of(rotation, position, z.data());
  EXPECT_LT((pose.place(z.data()).rotation - rotation).norm(), 1e-14);
  EXPECT_LT((pose.place(z.data()).position - position).norm(), 1e-13);
}

TEST(SectionPose, RecentringKeepsThePose) {
  SectionPose pose(some_section(none));
  pose.set_time(1);
  std::vector<double> z = some_unknowns(6);
  const SectionPlacement before = pose.place(z.data());
  EXPECT_GT(pose.recentre(z.data()), 0) << "its turning moment was that of another rotation";
  const SectionPlacement after = pose.place(z.data());
  EXPECT_LT((before.rotation - after.rotation).norm(), 1e-14);
  EXPECT_LT((before.position - after.position).norm(), 1e-14);
  EXPECT_EQ(after.vector.norm(), 0);
  EXPECT_LT(pose.recentre(z.data()), 1e-14) << "and again it changes nothing";
}

TEST(SectionPose, TheLoadsGradientIsThatOfItsPotential) {
  for (const Fixed& fixed : {none, two_turns, spin}) {
    SectionPose pose(some_section(fixed));
    pose.set_time(0.8);
    const std::vector<double> z = some_unknowns(pose.unknowns());
    const auto potential = [&](const std::vector<double>& at) {
      Vec6 unused = Vec6::Zero();
      return pose.load(pose.place(at.data()), at.data(), unused);
    };
    Vec6 gradient = Vec6::Zero();
    pose.load(pose.place(z.data()), z.data(), gradient);
    for (int k = 0; k < pose.unknowns(); ++k) {
      std::vector<double> plus = z, minus = z;
      plus[static_cast<size_t>(k)] += 1e-5;
      minus[static_cast<size_t>(k)] -= 1e-5;
      EXPECT_NEAR(gradient[k], (potential(plus) - potential(minus)) / 2e-5, 1e-9);
    }
  }
}

TEST(SectionPose, AMomentHasAnEnergyOnlyAboutOneAxis) {
  EXPECT_TRUE(SectionPose(some_section(spin)).has_potential());
  EXPECT_TRUE(SectionPose(some_section(all_fixed)).has_potential());
  EXPECT_FALSE(SectionPose(some_section(none)).has_potential());
  HeldSection force_alone = some_section(none);
  force_alone.moment = force_alone.body_moment = Vec3::Zero();
  EXPECT_TRUE(SectionPose(force_alone).has_potential());
  EXPECT_TRUE(SectionPose(force_alone).loaded());
  force_alone.force = Vec3::Zero();
  EXPECT_FALSE(SectionPose(force_alone).loaded());
}

TEST(HeldSection, ScaledLengthsAndForcesKeepTheirRatios) {
  const HeldSection section = some_section(none);
  const HeldSection small = scaled(section, 10, 4, Vec3(1, 1, 1));
  EXPECT_LT((small.rest.position - (section.rest.position - Vec3(1, 1, 1)) / 10).norm(), 1e-15);
  EXPECT_LT((small.motion.move - section.motion.move / 10).norm(), 1e-15);
  EXPECT_EQ(small.motion.rotate, section.motion.rotate);
  EXPECT_LT((small.force - section.force / 4).norm(), 1e-15);
  EXPECT_LT((small.moment - section.moment / 40).norm(), 1e-15);
  EXPECT_LT((small.body_moment - section.body_moment / 40).norm(), 1e-15);
}

}  // namespace
}  // namespace vasorod
