#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "geometry/noisy_tube.h"
#include "geometry/plane_section.h"

namespace vasorod {
namespace {

TEST(PlaneSection, SectionOfAStraightTubeIsItsPolygon) {
  const int n = 24;
  const double radius = 5;
  testing::TubeShape shape;
  shape.around = n;
  shape.radius = radius;
  const auto tube = testing::noisy_tube(shape);
  // The height of a row: vertices exactly on the plane must not break the loop. The section there
  // is a regular polygon.
  const auto loops = plane_sections(tube, {0, 0, 40.0 / 30 * 7}, Vec3::UnitZ());
  ASSERT_EQ(loops.size(), 1U);
  EXPECT_TRUE(loops[0].closed);
  EXPECT_NEAR(section_area(loops[0]), 0.5 * n * radius * radius * std::sin(2 * M_PI / n), 1e-11);
  EXPECT_NEAR(section_perimeter(loops[0]), 2 * n * radius * std::sin(M_PI / n), 1e-11);
  EXPECT_NEAR((section_centroid(loops[0]) - Vec3(0, 0, 40.0 / 30 * 7)).norm(), 0, 1e-12);
}

TEST(PlaneSection, ObliqueSectionOfAFineTubeIsAnEllipse) {
  testing::TubeShape shape;
  shape.around = 200;
  shape.along = 250;
  shape.jitter = 0.2;
  const auto tube = testing::noisy_tube(shape);
  const Vec3 normal = Vec3(std::sin(0.5), 0, std::cos(0.5));
  const auto loops = plane_sections(tube, {0, 0, 20}, normal);
  ASSERT_EQ(loops.size(), 1U);
  EXPECT_NEAR(section_area(loops[0]) / (M_PI * 25 / std::cos(0.5)), 1, 1e-3);
  EXPECT_NEAR((section_centroid(loops[0]) - Vec3(0, 0, 20)).norm(), 0, 1e-2);
  // Counter-clockwise about the normal.
  Vec3 turned = Vec3::Zero();
  const Points& p = loops[0].points;
  for (Eigen::Index i = 0; i < p.rows(); ++i) {
    const Vec3 a = p.row(i), b = p.row((i + 1) % p.rows());
    turned += 0.5 * a.cross(b);
  }
  EXPECT_GT(turned.dot(normal), 0);
  for (Eigen::Index i = 0; i < p.rows(); ++i)
    EXPECT_NEAR((p.row(i).transpose() - Vec3(0, 0, 20)).dot(normal), 0, 1e-12);
}

TEST(PlaneSection, APlaneThatMeetsABentTubeTwiceGivesTwoLoopsAndTheOneAskedForIsFound) {
  const testing::TubeShape shape = testing::u_bend();
  const auto tube = testing::noisy_tube(shape);
  const auto here = testing::tube_frame(shape, 12), there = testing::tube_frame(shape, 48);
  const Vec3 normal = here.rotation.col(2);
  const auto loops = plane_sections(tube, here.position, Vec3::UnitZ());
  ASSERT_EQ(loops.size(), 2U);
  EXPECT_GT(normal.z(), 0.5);
  const int a = section_around(loops, here.position, Vec3::UnitZ());
  const int b = section_around(loops, there.position, Vec3::UnitZ());
  EXPECT_NE(a, b);
  EXPECT_LT((section_centroid(loops[static_cast<size_t>(a)]) - here.position).norm(), 2.5);
  EXPECT_LT((section_centroid(loops[static_cast<size_t>(b)]) - there.position).norm(), 2.5);
}

TEST(PlaneSection, APlaneThroughAnEndGivesAnOpenCurve) {
  const auto tube = testing::noisy_tube({});
  const auto loops = plane_sections(tube, {0, 0, 1}, Vec3(1, 0, 1).normalized());
  ASSERT_EQ(loops.size(), 1U);
  EXPECT_FALSE(loops[0].closed);
  EXPECT_EQ(loops[0].points.rows(), static_cast<Eigen::Index>(loops[0].triangles.size()) + 1);
  EXPECT_TRUE(plane_sections(tube, {0, 0, 100}, Vec3::UnitZ()).empty());
  EXPECT_EQ(section_around({}, Vec3::Zero(), Vec3::UnitZ()), -1);
}

TEST(PlaneSection, ManyPlanesThroughATreeGiveTheSameCurves) {
  const testing::TubeShape shape = testing::u_bend();
  const auto tube = testing::noisy_tube(shape);
  const PlaneSections planes(tube);
  for (int k = 0; k <= 20; ++k)
    for (const Vec3& normal : {Vec3(0, 0, 1), Vec3(0.6, 0, 0.8), Vec3(1, 0, 0)}) {
      const Vec3 point = testing::tube_frame(shape, 3. * k).position;
      const auto expected = plane_sections(tube, point, normal),
                 found = planes.across(point, normal);
      ASSERT_EQ(found.size(), expected.size()) << k;
      for (size_t i = 0; i < found.size(); ++i) {
        EXPECT_EQ(found[i].points, expected[i].points);
        EXPECT_EQ(found[i].triangles, expected[i].triangles);
        EXPECT_EQ(found[i].closed, expected[i].closed);
      }
    }
}

TEST(PlaneSection, InsetAreaOfACircleIsTheSmallerCircle) {
  SectionLoop loop;
  const int n = 4000;
  loop.points.resize(n, 3);
  for (int i = 0; i < n; ++i)
    loop.points.row(i) << 3 * std::cos(2 * M_PI * i / n), 3 * std::sin(2 * M_PI * i / n), 1;
  EXPECT_NEAR(inset_area(loop, 0.5), M_PI * 2.5 * 2.5, 1e-4);
  EXPECT_EQ(inset_area(loop, 3.1), 0);
}

}  // namespace
}  // namespace vasorod
