#include <cmath>
#include <gtest/gtest.h>
#include <random>

#include <vasorod/error.h>

#include "data/index.h"
#include "surgery/ellipse.h"
#include "surgery/surface_checks.h"
#include "surgery/tube_binding.h"

namespace vasorod {
namespace {

using testing::TubeShape;

// Perimeter by the library's complete elliptic integral of the second kind.
double exact_perimeter(double length, double width) {
  const double a = std::max(length, width) / 2, b = std::min(length, width) / 2;
  return 4 * a * std::comp_ellint_2(std::sqrt(1 - b * b / (a * a)));
}

TubeShape smooth_tube(int around) {
  TubeShape shape;
  shape.around = around;
  shape.along = around * 4 / 3;
  return shape;
}

IncisionOutcome open(const TubeShape& shape, const TriangleSurface& tube, const Vec3& pick,
                     double length, double width) {
  return open_ellipse(tube, testing::tube_rod(shape), testing::tube_binding(shape, tube.points), {},
                      pick, length, width, shape.radius);
}

TEST(Ellipse, ThePerimeterIsTheCompleteEllipticIntegral) {
  for (const double width : {0.01, 0.4, 1.0, 3.7, 8.0, 11.0})
    EXPECT_NEAR(ellipse_perimeter(8, width) / exact_perimeter(8, width), 1, 1e-13) << width;
  EXPECT_DOUBLE_EQ(ellipse_perimeter(8, 0), 16);
  for (const double width : {0.5, 3.0, 5.9}) {
    const double length = ellipse_length(20, width);
    EXPECT_GE(length, width);
    EXPECT_NEAR(exact_perimeter(length, width), 20, 1e-11) << width;
  }
  EXPECT_NEAR(ellipse_length(M_PI * 5, 5), 5, 1e-6);  // a circle
}

// On a cylinder: area, perimeter, length and width of the hole converge to the ellipse's on the
// unrolled wall, and its rim lies on that ellipse.
TEST(Ellipse, OnACylinderTheHoleIsTheUnrolledEllipse) {
  for (const auto& [length, width] : {std::pair(8.4, 4.4), {6.0, 10.0}, {12.0, 3.0}}) {
    SCOPED_TRACE(length);
    for (const int around : {32, 64, 128}) {
      TubeShape shape = smooth_tube(around);
      shape.jitter = 0.2;
      const auto tube = testing::noisy_tube(shape);
      const double theta = 2.9, s = 19.3;  // beside the jump of the angle
      const auto outcome = open(shape, tube, testing::on_tube(shape, theta, s, 5.2), length, width);
      const double second_order = 40.0 / (around * around);
      EXPECT_NEAR(outcome.removed_area / (M_PI * length * width / 4), 1, 1.5 * second_order);
      EXPECT_NEAR(outcome.removed_area, total_area(tube) - total_area(outcome.surface),
                  100 * second_order);
      EXPECT_NEAR(outcome.perimeter / exact_perimeter(length, width), 1, second_order);
      EXPECT_NEAR(outcome.length / length, 1, second_order);
      EXPECT_NEAR(outcome.width / width, 1, second_order);
      const auto exact = testing::tube_binding(shape, outcome.surface.points);
      for (const int v : outcome.rim) {
        const Vec3 local = exact[index(v)].local;
        const double across =
            5 * std::remainder(std::atan2(local.y(), local.x()) - theta, 2 * M_PI);
        const double size = std::hypot(2 * (exact[index(v)].s - s) / length, 2 * across / width);
        EXPECT_NEAR(size, 1, 3 * second_order);
      }
      // The tips: on the axis, the first one at the smaller s.
      for (const auto& [k, side] : {std::pair(0, -1.0), {outcome.other_tip, 1.0}}) {
        const Vec3 tip = outcome.surface.points.row(outcome.rim[index(k)]);
        const Vec3 wanted = testing::on_tube(shape, theta, s + side * length / 2, 5);
        EXPECT_LT((tip - wanted).norm(), 20 * second_order);
      }
    }
  }
}

TEST(Ellipse, DozensOfHolesInIrregularWallsAreClean) {
  std::mt19937 random(12);
  std::uniform_real_distribution<double> uniform(0, 1);
  testing::MadeBySurgery worst;
  for (int i = 0; i < 80; ++i) {
    SCOPED_TRACE("ellipse " + std::to_string(i));
    const int around = 20 + static_cast<int>(uniform(random) * 40);
    const TubeShape shape = testing::irregular_shape(i, around, 1.2, random);
    const auto tube = testing::noisy_tube(shape);
    const double theta = 2 * M_PI * uniform(random), s = 14 + 12 * uniform(random);
    const double length = 5 + 9 * uniform(random), width = 3.6 + 6 * uniform(random);
    const auto outcome =
        open(shape, tube, testing::on_tube(shape, theta, s, 5 + uniform(random)), length, width);

    ASSERT_TRUE(testing::tube_with_a_hole(outcome.surface.triangles, outcome.rim));
    const auto components_of =
        components(outcome.surface.triangles, static_cast<int>(outcome.surface.points.rows()));
    EXPECT_EQ(*std::max_element(components_of.begin(), components_of.end()), 0);

    EXPECT_NEAR(outcome.length / length, 1, 0.05);
    EXPECT_NEAR(outcome.width / width, 1, 0.05);
    EXPECT_NEAR(outcome.removed_area / (M_PI * length * width / 4), 1, 0.07);
    EXPECT_NEAR(outcome.removed_area + total_area(outcome.surface), total_area(tube),
                2e-3 * total_area(tube));
    EXPECT_LT(testing::source_error(tube, outcome.surface, outcome.sources), 1e-11);
    const auto made = testing::made_by_surgery(tube, outcome.surface, outcome.sources);
    worst.shortest_edge = std::min(worst.shortest_edge, made.shortest_edge);
    worst.smallest_angle = std::min(worst.smallest_angle, made.smallest_angle);
  }
  EXPECT_GT(worst.shortest_edge, 0.05);
  EXPECT_GT(worst.smallest_angle, 4);
}

// Lengths are those on the wall: on a bent tube, the hole covers more of the axis on the inner side
// (10.3 here) than on the outer one (8.0). Such a wall cannot be unrolled without stretch, of about
// 1 % here.
TEST(Ellipse, OnABentTubeLengthsAreThoseOfTheWall) {
  TubeShape shape = smooth_tube(64);
  shape.bend = 1.0;
  const auto tube = testing::noisy_tube(shape);
  const double arc = shape.length / shape.bend;
  for (const double theta : {0.0, M_PI / 2, M_PI}) {
    const auto outcome = open(shape, tube, testing::on_tube(shape, theta, 20, 5), 9, 4);
    const auto exact = testing::tube_binding(shape, outcome.surface.points);
    const double covered =
        exact[index(outcome.rim[index(outcome.other_tip)])].s - exact[index(outcome.rim.front())].s;
    EXPECT_NEAR(covered, 9 * arc / (arc - 5 * std::cos(theta)), 0.15) << theta;
    EXPECT_NEAR(outcome.removed_area / (M_PI * 9), 1, 0.02);
  }
}

TEST(Ellipse, AMovedOrMirroredVesselHasTheMovedOrMirroredHole) {
  TubeShape shape = smooth_tube(40);
  shape.jitter = 0.25;
  shape.bend = 0.7;
  const auto tube = testing::noisy_tube(shape);
  const auto rod = testing::tube_rod(shape);
  const auto binding = testing::tube_binding(shape, tube.points);
  const Vec3 pick = testing::on_tube(shape, 2, 18, 5);
  const auto outcome = open_ellipse(tube, rod, binding, {}, pick, 8.4, 4.4, 5);
  const auto tips = [](const IncisionOutcome& of) {
    return std::array<Vec3, 2>{of.surface.points.row(of.rim.front()),
                               of.surface.points.row(of.rim[index(of.other_tip)])};
  };
  const auto expect_alike = [&](const IncisionOutcome& other, const auto& image) {
    EXPECT_NEAR(other.removed_area, outcome.removed_area, 1e-6);
    EXPECT_NEAR(other.perimeter, outcome.perimeter, 1e-6);
    EXPECT_EQ(other.rim.size(), outcome.rim.size());
    for (size_t k = 0; k < 2; ++k)
      EXPECT_LT((tips(other)[k] - image(tips(outcome)[k])).norm(), 1e-6);
  };

  const Pose motion{Eigen::AngleAxisd(1.9, Vec3(2, 1, -1).normalized()).toRotationMatrix(),
                    {50, -20, 8}};
  TriangleSurface moved = tube;
  for (int v = 0; v < tube.points.rows(); ++v)
    moved.points.row(v) = (motion * Vec3(tube.points.row(v))).transpose();
  RodTree moved_rod = rod;
  for (Pose& pose : moved_rod.rest) pose = motion * pose;
  expect_alike(open_ellipse(moved, moved_rod, binding, {}, motion * pick, 8.4, 4.4, 5),
               [&](const Vec3& p) { return Vec3(motion * p); });

  // Mirrored at the plane of the bend: d1 and d3 stay, d2 is reversed, and so is y in the sections.
  TriangleSurface mirrored = tube;
  mirrored.points.col(1) *= -1;
  mirrored.triangles.col(0).swap(mirrored.triangles.col(1));
  Binding mirrored_binding = binding;
  for (RodCoordinates& at : mirrored_binding) at.local.y() *= -1;
  expect_alike(open_ellipse(mirrored, rod, mirrored_binding, {}, {pick.x(), -pick.y(), pick.z()},
                            8.4, 4.4, 5),
               [](const Vec3& p) { return Vec3(p.x(), -p.y(), p.z()); });
}

std::string refusal(const TriangleSurface& tube, const TubeShape& shape,
                    const std::vector<int>& branches, const Vec3& pick, double length,
                    double width) {
  try {
    open_ellipse(tube, testing::tube_rod(shape), testing::tube_binding(shape, tube.points),
                 branches, pick, length, width, 5);
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Ellipse, BadEllipsesAreRefusedWithASentence) {
  TubeShape shape = smooth_tube(32);
  shape.jitter = 0.2;
  const auto tube = testing::noisy_tube(shape);
  std::vector<int> branches(index(tube.points.rows()), 0);
  for (int v = 0; v < tube.points.rows(); ++v)
    if (tube.points(v, 2) > 25) branches[index(v)] = 1;
  const auto says = [&](const Vec3& pick, double length, double width, const std::string& part) {
    const std::string said = refusal(tube, shape, branches, pick, length, width);
    EXPECT_NE(said.find(part), std::string::npos) << said;
  };
  says({5, 0, 8}, 20, 5, "an ellipse 20 long and 5 wide runs into an open end of the vessel near");
  says({5, 0, 19}, 14, 5, "runs into a fork of the vessel near");
  says({5, 0, 19}, 14, 5, "expected one of at most ");
  says({5, 0, 24}, 14, 5, "expected a pick farther from it");
  says({10.3, 0, 10}, 8, 4, "off the vessel");
  says({5, 0, 41}, 8, 4, "lies at an open end");
  says({5, 0, 12}, 8, 1, "too small for the vessel's triangles");
  says({5, 0, 12}, 6, 24, "goes too far around the vessel");
}

TEST(Ellipse, TheSizeThatFitsIsSaidAndFits) {
  TubeShape shape = smooth_tube(32);
  shape.jitter = 0.2;
  const auto tube = testing::noisy_tube(shape);
  for (const double s : {8.0, 31.0}) {  // the nearer end decides, whichever side it is on
    const std::string said = refusal(tube, shape, {}, {5, 0, s}, 34, 9);
    const std::string before = "expected one of at most ", between = " long and ";
    const auto at = said.find(before);
    ASSERT_NE(at, std::string::npos) << said;
    const std::string sizes = said.substr(at + before.size());
    const double length = std::stod(sizes),
                 width = std::stod(sizes.substr(sizes.find(between) + between.size()));
    EXPECT_NEAR(length / width, 34.0 / 9, 0.02);
    const double end = 2 * std::min(s, shape.length - s), edge = shape.length / shape.along;
    EXPECT_LT(length, end);
    EXPECT_GT(length, end - 5 * edge);
    EXPECT_NEAR(open(shape, tube, {5, 0, s}, length, width).length, length, 0.02 * length);
  }
}

}  // namespace
}  // namespace vasorod
