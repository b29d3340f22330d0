#include <Eigen/Geometry>
#include <cmath>

#include "planner/place.h"
#include "planner/small_scene.h"

namespace vasorod::planner {
namespace {

using Place = SmallScene;

Vec3 point_of(const Json& json) {
  return Vec3(json[0].get<double>(), json[1].get<double>(), json[2].get<double>());
}

double length_of(const Json& outline) {
  double length = 0;
  for (std::size_t i = 0; i < outline.size(); ++i)
    length += (point_of(outline[(i + 1) % outline.size()]) - point_of(outline[i])).norm();
  return length;
}

TEST_F(Place, TheOperationOfTheSceneIsDrawn) {
  const auto scene = opened();
  const Json drawn = placed_plan(*scene, *scene->plan);
  EXPECT_TRUE(drawn["problem"].is_null());
  const Result solved = predict(scene->scene, {}, scene->fitted);
  const GlennReport& report = *solved.glenn;
  EXPECT_NEAR((point_of(drawn["cut"]["point"]) - report.cut.point).norm(), 0, 1e-9);
  EXPECT_NEAR((point_of(drawn["cut"]["normal"]) - report.cut.normal).norm(), 0, 1e-9);
  EXPECT_NEAR(length_of(drawn["cut"]["outline"]), 2 * M_PI * 3.3, 0.02 * 2 * M_PI * 3.3);
  EXPECT_NEAR((point_of(drawn["incision"]["point"]) - report.incision.pick).norm(), 0, 1e-9);
  EXPECT_EQ(drawn["incision"]["length"], report.incision.length);
  // A slit's outline goes there and back.
  EXPECT_NEAR(length_of(drawn["incision"]["outline"]), 2 * report.incision.length,
              0.01 * report.incision.length);
}

TEST_F(Place, ATiltedCutLeans) {
  const auto scene = opened();
  Plan plan = *scene->plan;
  plan.cut_tilt_deg = 30;
  const Json drawn = placed_plan(*scene, plan);
  EXPECT_NEAR(std::abs(point_of(drawn["cut"]["normal"]).z()), std::cos(M_PI / 6), 1e-3);
}

TEST_F(Place, WhatCannotBeBuiltIsDrawnAsFarAsItGoes) {
  const auto scene = opened();
  Plan plan = *scene->plan;
  plan.incision_along = 0.03;
  Json drawn = placed_plan(*scene, plan);
  EXPECT_NE(drawn["problem"].get<std::string>().find("incision"), std::string::npos);
  EXPECT_FALSE(drawn["cut"]["outline"].empty());
  EXPECT_NEAR(point_of(drawn["incision"]["point"]).x(), -25 + 0.03 * 50, 0.05);
  EXPECT_EQ(drawn["incision"]["ends"].size(), 2U);
  plan = *scene->plan;
  plan.cut_along = 0;
  drawn = placed_plan(*scene, plan);
  EXPECT_TRUE(drawn["problem"].is_string());
  plan = *scene->plan;
  plan.incision_length = 4;  // 41 mm, and the artery's end is 15 mm away
  plan.incision_along = 0.3;
  EXPECT_TRUE(placed_plan(*scene, plan)["problem"].is_string());
}

}  // namespace
}  // namespace vasorod::planner
