// Ends too short for their width, on tubes of known size.
#include <gtest/gtest.h>

#include <vasorod/error.h>

#include "prepare/open_ends.h"
#include "prepare/open_tip.h"
#include "prepare/repair.h"
#include "prepare/tube_shapes.h"

namespace vasorod::testing {
namespace {

constexpr double radius = 5;

TEST(OpenEnds, ALongTubeIsOpenedBehindItsTips) {
  TriangleSurface tube = closed_tube(60, radius, true);
  const OpenedEnds opened = open_ends(tube, {});
  EXPECT_EQ(boundary_loops(tube.triangles).size(), 2U);
  EXPECT_EQ(opened.done.size(), 2U);
  EXPECT_TRUE(opened.warnings.empty());
}

// Of a length of two radii no section across the axis is found from the tips.
TEST(OpenEnds, AShortTubeIsOpenedAlongItsFlatCaps) {
  const double length = 2 * radius;
  TriangleSurface tube = closed_tube(length, radius, false);
  const OpenedEnds opened = open_ends(tube, {});
  EXPECT_EQ(boundary_loops(tube.triangles).size(), 2U);
  EXPECT_TRUE(opened.warnings.empty()) << opened.warnings.front();
  // Nothing but the caps and a little of the tube is gone.
  EXPECT_LT(tube.points.col(2).minCoeff(), 0.2 * radius);
  EXPECT_GT(tube.points.col(2).maxCoeff(), length - 0.2 * radius);
  for (const auto& loop : boundary_loops(tube.triangles))
    EXPECT_LT(unevenness(tube.points, loop), 1e-9);
}

// As branches that are cut off at the wall that they leave.
TEST(OpenEnds, AFlatCapOfATubeThatGoesOnWideningIsOpened) {
  const double length = 2 * radius;
  TriangleSurface tube = closed_tube(length, radius, false);
  for (Eigen::Index v = 0; v < tube.points.rows(); ++v)
    tube.points.row(v).head<2>() *= 1 + 0.6 * tube.points(v, 2) / length;
  const auto caps = find_caps(tube, 0.2 * radius);
  const auto narrow = std::find_if(caps.begin(), caps.end(),
                                   [](const FlatCap& cap) { return cap.normal.z() < -0.99; });
  ASSERT_NE(narrow, caps.end());
  EXPECT_TRUE(surely_cut(*narrow));
  EXPECT_TRUE(sections_behind_cap(tube, *narrow, false).empty());
  const auto sections = sections_behind_cap(tube, *narrow, true);
  ASSERT_FALSE(sections.empty());
  EXPECT_NEAR(sections.front().center.z(), 0.15 * narrow->radius, 1e-9);
  open_ends(tube, {});
  const auto loops = boundary_loops(tube.triangles);
  EXPECT_TRUE(std::any_of(loops.begin(), loops.end(), [&](const auto& loop) {
    return tube.points(loop.front(), 2) < 0.2 * radius;
  }));
}

TEST(OpenEnds, ANamedCapIsOpenedAndTheOtherIsNot) {
  TriangleSurface tube = closed_tube(2 * radius, radius, false);
  EndsToOpen wanted;
  wanted.places = {Vec3::Zero()};
  open_ends(tube, wanted);
  const auto loops = boundary_loops(tube.triangles);
  ASSERT_EQ(loops.size(), 1U);
  EXPECT_LT(tube.points(loops.front().front(), 2), 0.2 * radius);
}

TEST(OpenEnds, APlaceWithoutAnEndIsRefusedWithTheEndsThereAre) {
  TriangleSurface tube = closed_tube(60, radius, false);
  EndsToOpen wanted;
  wanted.places = {Vec3(0, 0, 30)};
  try {
    open_ends(tube, wanted);
    FAIL();
  } catch (const InputError& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find("no closed end within three radii of (0, 0, 30), expected ("),
              std::string::npos)
        << text;
  }
}

}  // namespace
}  // namespace vasorod::testing
