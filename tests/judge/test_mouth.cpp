#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "geometry/rigid_motion.h"
#include "judge/judged_tube.h"
#include "judge/mouth.h"

namespace vasorod {
namespace {

using shapes::judged_tube;
using std::numbers::pi;

constexpr int around = 720;

// A vein whose only points are its mouth: a circle of radius 10 at rest; thickness 1.
PreparedVessel round_mouth() {
  PreparedVessel vein = judged_tube();
  Points circle(around, 3);
  for (int k = 0; k < around; ++k) {
    const double a = 2 * pi * k / around;
    circle.row(k) << 10 * std::cos(a), 10 * std::sin(a), 0;
  }
  vein.vessel.surface.points = circle;
  return vein;
}

std::vector<std::array<int, 2>> all_pairs() {
  std::vector<std::array<int, 2>> pairs;
  for (int k = 0; k < around; ++k) pairs.push_back({k, k});
  return pairs;
}

// An ellipse on a saddle: its projection has the semi-axes a and b.
Points saddle(double a, double b, double height) {
  Points points(around, 3);
  for (int k = 0; k < around; ++k) {
    const double angle = 2 * pi * k / around;
    points.row(k) << a * std::cos(angle), b * std::sin(angle), height * std::cos(2 * angle);
  }
  return points;
}

double ellipse_perimeter(double a, double b) {
  double perimeter = 0;
  for (int k = 0; k < 4096; ++k) {
    const double angle = 2 * pi * (k + 0.5) / 4096;
    perimeter += std::hypot(a * std::sin(angle), b * std::cos(angle)) * 2 * pi / 4096;
  }
  return perimeter;
}

TEST(Mouth, OfAnEllipse) {
  const Points flat = saddle(12, 7, 0);
  const MouthReport mouth = measure_mouth(round_mouth(), flat, flat, all_pairs(), Vec3::UnitZ());
  const double perimeter = ellipse_perimeter(12, 7), lumen = 84 * pi - perimeter / 2 + pi / 4;
  EXPECT_NEAR(mouth.area, 84 * pi, 0.01);
  EXPECT_NEAR(mouth.lumen, lumen, 0.01);
  EXPECT_NEAR(mouth.area_ratio, lumen / (pi * 9.5 * 9.5), 1e-4);
  EXPECT_NEAR(mouth.span, 24, 1e-9);
  EXPECT_NEAR(mouth.width, 14, 1e-9);
  EXPECT_NEAR(mouth.perimeter, perimeter, 0.01);
  EXPECT_NEAR(mouth.perimeter_ratio, perimeter / (20 * pi), 1e-4);
  EXPECT_NEAR(mouth.center.norm(), 0, 1e-9);
}

// An oblique cut's mouth is longer at rest, but the vein's lumen is what it was.
TEST(Mouth, OfAnObliqueCutIsComparedWithTheVeinsLumen) {
  PreparedVessel vein = round_mouth();
  vein.vessel.surface.points.col(2) = 0.8 * vein.vessel.surface.points.col(0);
  const double length = 10 * std::hypot(1, 0.8);
  const Points now = saddle(length, 10, 0);
  const MouthReport mouth = measure_mouth(vein, now, now, all_pairs(), Vec3::UnitZ());
  const double perimeter = ellipse_perimeter(length, 10),
               lumen = length * 10 * pi - perimeter / 2 + pi / 4;
  EXPECT_NEAR(mouth.area_ratio, lumen / (pi * 9.5 * 9.5), 1e-4);
  EXPECT_NEAR(mouth.perimeter_ratio, 1, 1e-4);
}

TEST(Mouth, IsMeasuredInItsProjectionAndMovesWithTheWalls) {
  const Points flat = saddle(12, 7, 0), bowed = saddle(12, 7, 3);
  const MouthReport before = measure_mouth(round_mouth(), flat, flat, all_pairs(), Vec3::UnitZ());
  Vec6 motion;
  motion << 5, -3, 2, 0.4, 1.1, -0.7;
  const Pose pose = exp_motion(motion);
  Points moved(around, 3);
  for (int k = 0; k < around; ++k)
    moved.row(k) = pose.rotation * bowed.row(k).transpose() + pose.position;
  const MouthReport now = measure_mouth(round_mouth(), moved, moved, all_pairs(), Vec3::UnitZ());
  EXPECT_NEAR(now.area, before.area, 1e-9);
  EXPECT_NEAR(now.span, before.span, 1e-9);
  EXPECT_NEAR(now.width, before.width, 1e-9);
  EXPECT_GT(now.perimeter, before.perimeter);
  EXPECT_NEAR((now.center - pose.position).norm(), 0, 1e-9);
}

// The seam runs midway between vein and recipient, and the vein's given surface may be its inner
// face: mid-wall lies half a thickness further out.
TEST(Mouth, RunsMidwayAndAtMidWall) {
  PreparedVessel vein = round_mouth();
  const MouthReport between =
      measure_mouth(vein, saddle(10, 10, 0), saddle(12, 12, 0), all_pairs(), Vec3::UnitZ());
  EXPECT_NEAR(between.area, 121 * pi, 0.01);
  vein.spec.surface_is = SurfaceIs::inner;
  const MouthReport inner =
      measure_mouth(vein, saddle(10, 10, 0), saddle(10, 10, 0), all_pairs(), Vec3::UnitZ());
  EXPECT_NEAR(inner.area, 10.5 * 10.5 * pi, 0.02);
  EXPECT_NEAR(inner.lumen, 100 * pi, 0.02);
  EXPECT_NEAR(inner.area_ratio, 1, 1e-9);
  EXPECT_NEAR(inner.span, 21, 1e-9);
}

TEST(Mouth, NarrowOnesAreWarnedOfAndCountAsTheVeinsNarrowestSection) {
  const auto judged = [](double ratio) {
    MouthReport mouth;
    mouth.area_ratio = ratio;
    mouth.center = {1, 2, 3};
    VesselMetrics metrics;
    metrics.smallest_lumen_ratio = 0.75;
    Validity validity;
    judge_mouth("svc", mouth, metrics, validity);
    return std::pair(metrics, validity);
  };
  const auto [wide, quiet] = judged(0.8);
  EXPECT_EQ(wide.smallest_lumen_ratio, 0.75);
  EXPECT_TRUE(quiet.warnings.empty());
  const auto [narrow, warned] = judged(0.5);
  EXPECT_EQ(narrow.smallest_lumen_ratio, 0.5);
  EXPECT_EQ(narrow.where.at("smallest_lumen_ratio"), Vec3(1, 2, 3));
  ASSERT_EQ(warned.warnings.size(), 1U);
  EXPECT_NE(warned.warnings[0].find("a narrowing (below 0.6)"), std::string::npos)
      << warned.warnings[0];
  const auto [almost, close] = judged(0.599);
  ASSERT_EQ(close.warnings.size(), 1U);
  EXPECT_NE(close.warnings[0].find("its lumen is 0.599 of the cut vein's"), std::string::npos)
      << close.warnings[0];
  const auto [slit, strong] = judged(0.25);
  ASSERT_EQ(strong.warnings.size(), 1U);
  EXPECT_NE(strong.warnings[0].find("a severe narrowing (below 0.4)"), std::string::npos)
      << strong.warnings[0];
  EXPECT_TRUE(strong.in_range);  // a narrow mouth may well be what the model says
}

TEST(Mouth, TheElementsOverTheIncisionAreOpen) {
  const PreparedVessel tube = judged_tube();
  const Points& points = tube.vessel.surface.points;
  int first = -1, last = -1;  // vertices of one line, 40 and 60 along the tube
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    if (std::abs(points(i, 2) - 40) < 0.7) first = static_cast<int>(i);
    if (std::abs(points(i, 2) - 60) < 0.7) last = static_cast<int>(i);
  }
  ASSERT_TRUE(first >= 0 && last >= 0);
  const auto opened = opened_elements(tube, {{0, first}, {0, last}});
  const RodTree& rod = tube.vessel.rod;
  ASSERT_EQ(opened.size(), rod.elements.size());
  for (size_t e = 0; e < opened.size(); ++e) {
    const double middle = (rod.rest[static_cast<size_t>(rod.elements[e].first)].position +
                           rod.rest[static_cast<size_t>(rod.elements[e].second)].position)
                              .z() /
                          2;
    if (middle > 38 && middle < 42) continue;  // the slit's tips lie there
    if (middle > 58 && middle < 62) continue;
    EXPECT_EQ(opened[e] != 0, middle > 42 && middle < 58) << middle;
  }
}

}  // namespace
}  // namespace vasorod
