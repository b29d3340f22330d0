#include <cmath>

#include "planner/hand_made_result.h"
#include "planner/sections.h"
#include "planner/small_scene.h"

namespace vasorod::planner {
namespace {

using Sections = SmallScene;

TEST_F(Sections, AcrossATubeIsACircle) {
  const auto scene = opened();
  const Json vessels = section_at_rest(*scene, {{0, 0, 25}, {0, 0, 1}})["vessels"];
  ASSERT_EQ(vessels.size(), 1U);
  const double area = M_PI * 3.3 * 3.3, perimeter = 2 * M_PI * 3.3;
  EXPECT_EQ(vessels[0]["name"], "svc");
  EXPECT_EQ(vessels[0]["closed"].dump(), "[true]");
  EXPECT_NEAR(vessels[0]["area"].get<double>(), area, 0.02 * area);
  EXPECT_NEAR(vessels[0]["perimeter"].get<double>(), perimeter, 0.01 * perimeter);
  const double lumen = M_PI * 3.1 * 3.1;  // of the mid-wall radius half the thickness is wall
  EXPECT_NEAR(vessels[0]["lumen"].get<double>(), lumen, 0.02 * lumen);
}

TEST_F(Sections, AlongATubeIsNoClosedCurve) {
  const auto scene = opened();
  for (const Json& one : section_at_rest(*scene, {{0, 0, 25}, {0, 1, 0}})["vessels"]) {
    EXPECT_EQ(one["loops"].size(), 2U);
    EXPECT_EQ(one["closed"].dump(), "[false,false]");
    EXPECT_TRUE(one["area"].is_null());
    EXPECT_TRUE(one["lumen"].is_null());
  }
  EXPECT_TRUE(section_at_rest(*scene, {{0, 0, 500}, {0, 0, 1}})["vessels"].empty());
}

TEST_F(Sections, OfAResultAreInItsShape) {
  const auto stored = hand_made();
  const Json vessels = section_in_result(*stored, {{0.5, 0, 0}, {1, 0, 0}})["vessels"];
  ASSERT_EQ(vessels.size(), 2U);
  for (const Json& point : vessels[0]["loops"][0]) {
    EXPECT_EQ(point[0], 0.5);
    EXPECT_EQ(point[2], 1);  // not the 0 at rest
  }
}

TEST_F(Sections, ANormalOfNoLengthIsRefused) {
  EXPECT_EQ(read_plane(Body(R"({"point": [0, 0, 0], "normal": [0, 0, 5]})")).normal, Vec3::UnitZ());
  const Body body(R"({"point": [0, 0, 0], "normal": [0, 0, 0]})");
  EXPECT_EQ(refusal_of([&] { read_plane(body); }).status, 400);
}

}  // namespace
}  // namespace vasorod::planner
