#include "planner/small_scene.h"

namespace vasorod::planner {
namespace {

Plan read_back(const Plan& plan) {
  return read_plan(Body(json_of(plan).dump()));
}

TEST(Plan, IsReadAsItWasWritten) {
  Plan plan;
  EXPECT_EQ(read_back(plan), plan);
  plan = {0.123456789012345678, -12.5,          1.0 / 3, -177.25, 0.3, 0.4, 1e-17,
          RouteEnds{1, 0},      RouteEnds{0, 2}};
  EXPECT_EQ(read_back(plan), plan);
  EXPECT_EQ(json_of(Plan{})["shape"], "slit");
  EXPECT_TRUE(json_of(Plan{})["rotation_deg"].is_null());
}

TEST(Plan, WhatIsMissingOrBeyondItsRangeIsSaid) {
  const Json good = json_of(Plan{});
  const auto said = [&](auto&& change) {
    Json plan = good;
    change(plan);
    return std::string(refusal_of([&] { read_plan(Body(plan.dump())); }).what());
  };
  for (const char* key : {"cut", "incision", "cut_tilt_deg", "incision_length"})
    EXPECT_EQ(said([&](Json& plan) { plan.erase(key); }).rfind(key, 0), 0U) << key;
  EXPECT_NE(said([](Json& plan) { plan["cut_tilt_deg"] = 75.1; }).find("-75 to 75"),
            std::string::npos);
  EXPECT_NE(said([](Json& plan) { plan["incision_length"] = 4.1; }).find("0.25 to 4"),
            std::string::npos);
  EXPECT_NE(said([](Json& plan) {
              plan["shape"] = {{"ellipse", 0.05}};
            }).find("0.1 to 1"),
            std::string::npos);
  EXPECT_NE(said([](Json& plan) {
              plan["incision"]["route"] = {1, 1};
            }).find("two different"),
            std::string::npos);
  EXPECT_NE(said([](Json& plan) {
              plan["incision"]["route"] = {0.5, 1};
            }).find("two different"),
            std::string::npos);
  EXPECT_NE(said([](Json& plan) { plan["stray"] = 1; }).find("stray"), std::string::npos);
}

}  // namespace
}  // namespace vasorod::planner
