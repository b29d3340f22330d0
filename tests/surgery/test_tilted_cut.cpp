#include <Eigen/Geometry>
#include <cmath>
#include <gtest/gtest.h>
#include <random>

#include <vasorod/error.h>

#include "data/index.h"
#include "geometry/noisy_tube.h"
#include "surgery/surface_checks.h"
#include "surgery/tilted_cut.h"

namespace vasorod {
namespace {

using testing::TubeShape;

CutOutcome cut(const TubeShape& shape, const TriangleSurface& tube, double s, double degrees,
               const Vec3& axis = Vec3::UnitX()) {
  const Pose section = testing::tube_frame(shape, s);
  return cut_obliquely(tube, {}, section, {degrees, section.rotation * axis}, section.position,
                       {0, 0, 0});
}

// The mouth of a cylinder of radius R is an ellipse with the semi-axes R and R / cos(tilt).
TEST(TiltedCut, OfACylinderIsAnEllipse) {
  for (const double degrees : {-60.0, -20.0, 15.0, 45.0, 70.0}) {
    SCOPED_TRACE(degrees);
    for (const int around : {24, 48, 96}) {
      TubeShape shape;
      shape.around = around;
      shape.along = around * 4 / 3;
      shape.jitter = 0.25;
      const auto tube = testing::noisy_tube(shape);
      const double tilt = degrees * M_PI / 180, a = 5 / std::cos(tilt);
      const double perimeter = 4 * a * std::comp_ellint_2(std::abs(std::sin(tilt)));
      const auto outcome = cut(shape, tube, 18, degrees);
      EXPECT_NEAR(outcome.perimeter / perimeter, 1, 14.0 / (around * around));
      // The normal (out of the kept part, z) turns about x towards -y.
      const Vec3 normal(0, -std::sin(tilt), std::cos(tilt));
      EXPECT_LT((outcome.normal - normal).norm(), 1e-12);
      for (const int v : outcome.mouth)
        EXPECT_LT(std::abs((Vec3(outcome.kept.points.row(v)) - Vec3(0, 0, 18)).dot(normal)), 1e-11);
      EXPECT_LT((outcome.center - Vec3(0, 0, 18)).norm(), 30.0 / (around * around));
      // Kept part and stump are the whole tube.
      EXPECT_EQ(euler_number(outcome.kept.triangles), 0);
      EXPECT_NEAR(total_area(outcome.kept), 2 * M_PI * 5 * 18, 600.0 / around);
      EXPECT_EQ(boundary_loops(outcome.stump.triangles).size(), 1U);
    }
  }
}

TEST(TiltedCut, DozensOfCutsOfIrregularBentTubesAreClean) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(0, 1);
  testing::MadeBySurgery worst;
  for (int i = 0; i < 60; ++i) {
    SCOPED_TRACE("cut " + std::to_string(i));
    const int around = 16 + static_cast<int>(uniform(random) * 40);
    const TubeShape shape = testing::irregular_shape(i, around, 1.2, random);
    const auto tube = testing::noisy_tube(shape);
    const double turn = 2 * M_PI * uniform(random);
    const double degrees = 120 * uniform(random) - 60;
    const auto outcome =
        cut(shape, tube, 17 + 6 * uniform(random), degrees, {std::cos(turn), std::sin(turn), 0});
    ASSERT_TRUE(testing::oriented(outcome.kept.triangles));
    EXPECT_EQ(boundary_loops(outcome.kept.triangles).size(), 2U);
    const double tilt = degrees * M_PI / 180;
    // Exact on a straight tube; a bend of at most 1.2 over 40 changes it in second order.
    const double exact = 4 * 5 / std::cos(tilt) * std::comp_ellint_2(std::abs(std::sin(tilt)));
    EXPECT_NEAR(outcome.perimeter / exact, 1, shape.bend == 0 ? 0.03 : 0.25);
    const auto made = testing::made_by_surgery(tube, outcome.kept, outcome.kept_sources);
    worst.shortest_edge = std::min(worst.shortest_edge, made.shortest_edge);
    worst.smallest_angle = std::min(worst.smallest_angle, made.smallest_angle);
  }
  EXPECT_GT(worst.shortest_edge, 0.05);
  EXPECT_GT(worst.smallest_angle, 3);
}

TEST(TiltedCut, AMovedOrMirroredVesselHasTheMovedOrMirroredMouth) {
  TubeShape shape;
  shape.around = 40;
  shape.along = 52;
  shape.bend = 0.8;
  shape.jitter = 0.25;
  const auto tube = testing::noisy_tube(shape);
  const Pose section = testing::tube_frame(shape, 19);
  const Vec3 axis = section.rotation * Vec3(0.6, 0.8, 0);
  const auto outcome = cut_obliquely(tube, {}, section, {35, axis}, section.position, {0, 0, 0});

  const Pose motion{Eigen::AngleAxisd(2.1, Vec3(1, 3, -1).normalized()).toRotationMatrix(),
                    {20, 40, -9}};
  TriangleSurface moved = tube, mirrored = tube;
  for (int v = 0; v < tube.points.rows(); ++v)
    moved.points.row(v) = (motion * Vec3(tube.points.row(v))).transpose();
  const auto of_moved = cut_obliquely(moved, {}, motion * section, {35, motion.rotation * axis},
                                      motion * section.position, motion * Vec3(0, 0, 0));
  EXPECT_NEAR(of_moved.perimeter, outcome.perimeter, 1e-9);
  EXPECT_LT((of_moved.center - motion * outcome.center).norm(), 1e-9);
  EXPECT_LT((of_moved.normal - motion.rotation * outcome.normal).norm(), 1e-12);

  // Mirrored in y, in which the tube's axis lies in the mirror: the axis of a turn is mirrored and
  // reversed.
  mirrored.points.col(1) *= -1;
  mirrored.triangles.col(0).swap(mirrored.triangles.col(1));
  const auto of_mirrored =
      cut_obliquely(mirrored, {}, section, {35, Vec3(-axis.x(), axis.y(), -axis.z())},
                    section.position, {0, 0, 0});
  // The curve is followed the other way, so that other short edges of it are merged.
  EXPECT_NEAR(of_mirrored.perimeter, outcome.perimeter, 1e-3 * outcome.perimeter);
  EXPECT_LT((of_mirrored.normal - Vec3(outcome.normal.x(), -outcome.normal.y(), outcome.normal.z()))
                .norm(),
            1e-12);
}

std::string refusal(const TriangleSurface& tube, const std::vector<int>& branches, double s,
                    double degrees) {
  try {
    Pose section;
    section.position = {0, 0, s};
    cut_obliquely(tube, branches, section, {degrees, Vec3::UnitX()}, section.position, {0, 0, 0});
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(TiltedCut, ATiltThatLeavesTheVesselIsRefusedWithTheOneThatFits) {
  TubeShape shape;
  shape.around = 48;
  shape.along = 80;
  const auto tube = testing::noisy_tube(shape);
  std::vector<int> branches(index(tube.points.rows()), 0);
  for (int v = 0; v < tube.points.rows(); ++v)
    if (tube.points(v, 2) > 28) branches[index(v)] = 1;
  // At s the plane reaches an end of the tube at tan(tilt) = (way to the end) / R; it has to keep
  // one triangle off. A fork likewise.
  const double edge = shape.length / shape.along;
  for (const auto& [s, sign, way, words] : {std::tuple(5.0, 1, 5.0, "runs into an open end"),
                                            {5.0, -1, 5.0, "runs into an open end"},
                                            {22.0, 1, 6.0, "runs into a fork"}}) {
    const std::string said = refusal(tube, branches, s, sign * 70);
    EXPECT_NE(said.find(words), std::string::npos) << said;
    const std::string before = sign > 0 ? "cut_tilt_deg: found 70, expected at most "
                                        : "cut_tilt_deg: found -70, expected "
                                          "at least ";
    ASSERT_EQ(said.find(before), 0U) << said;
    const int fits = std::stoi(said.substr(before.size()));
    EXPECT_LT(sign * fits, std::atan(way / 5) * 180 / M_PI + 1);
    EXPECT_GT(sign * fits, std::atan((way - 2 * edge) / 5) * 180 / M_PI - 1);
    EXPECT_EQ(refusal(tube, branches, s, fits), "accepted");
    EXPECT_NE(refusal(tube, branches, s, fits + sign), "accepted");
  }
  EXPECT_EQ(refusal(tube, {}, 20, 80), "cut_tilt_deg: found 80, expected -75 to 75");
  EXPECT_EQ(refusal(tube, {}, 20, std::nan("")), "cut_tilt_deg: found nan, expected -75 to 75");
  EXPECT_EQ(refusal(tube, {}, 20, 70), "accepted");
}

}  // namespace
}  // namespace vasorod
