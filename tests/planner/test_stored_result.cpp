#include <cmath>

#include "planner/hand_made_result.h"
#include "planner/small_scene.h"

namespace vasorod::planner {
namespace {

// A kilopascal in millimetres of mercury.
constexpr double mmhg = 1 / 0.133322387415;

TEST(StoredResult, FieldsHaveTheUnitsAndRangesOfTheReport) {
  const auto stored = hand_made();
  ASSERT_EQ(stored->fields.size(), 2U);
  const ShownField &stretch = stored->fields[0], &pressure = stored->fields[1];
  EXPECT_EQ(stretch.name, "AxialStretch");
  EXPECT_EQ(stretch.map, "diverging");
  EXPECT_EQ(stretch.neutral, 1);
  // 1 to 1.2; the scale reaches a strain of 0.2 at least and is symmetric.
  EXPECT_NEAR(stretch.low, 0.8, 1e-12);
  EXPECT_NEAR(stretch.high, 1.2, 1e-12);
  EXPECT_EQ(pressure.name, "ContactPressure");
  EXPECT_EQ(pressure.title, "contact pressure");
  EXPECT_EQ(pressure.unit, "mmHg");
  EXPECT_EQ(pressure.map, "sequential");
  EXPECT_NEAR(pressure.high, 2 * mmhg, 1e-9);
}

TEST(StoredResult, LinesAreTheRodsStrains) {
  const Json answer = json_of(*hand_made());
  ASSERT_EQ(answer["lines"].size(), 1U);
  const Json& line = answer["lines"][0];
  EXPECT_EQ(line["vessel"], "square");
  EXPECT_EQ(line["arc"].dump(), "[0.0,1.0,2.0]");
  EXPECT_EQ(line["point"][2].dump(), "[3.0,1.5,0.0]");
  EXPECT_EQ(line["lumen_area"].dump(), "[1.0,null,3.0]");
  EXPECT_EQ(line["stretch"][0], 1.5);
  EXPECT_NEAR(line["twist_deg_per_length"][0], 0.2 * 180 / M_PI, 1e-12);
  EXPECT_NEAR(line["curvature"][0], 0.5, 1e-12);
  EXPECT_EQ(line["radius"].dump(), "[0.5,0.6,0.7]");
  EXPECT_EQ(answer["vessels"][0]["fields"].size(), 2U);
  EXPECT_EQ(answer["vessels"][1]["role"], "obstacle");
  EXPECT_TRUE(answer["vessels"][1]["fields"].empty());
  EXPECT_EQ(answer["json"]["scene"], "hand-made");
}

TEST(StoredResult, WhatAResultHasNotIsNull) {
  Result result = hand_made_result();
  CenterlineResult& rod = *result.vessels[0].centerline;
  rod.u.clear();
  rod.lumen_area.clear();
  rod.radius.clear();
  result.vessels[0].stump = TriangleSurface{result.vessels[0].rest, result.vessels[0].triangles};
  result.status = Status::iteration_limit;
  const Json answer = json_of(StoredResult("r2", std::move(result), Plan{}, "{}"));
  const Json& line = answer["lines"][0];
  for (const char* key : {"stretch", "twist_deg_per_length", "curvature", "lumen_area", "radius"})
    EXPECT_TRUE(line[key].is_null()) << key;
  EXPECT_EQ(answer["vessels"][1]["name"], "square_stump");
  EXPECT_EQ(answer["vessels"][1]["role"], "stump");
  EXPECT_EQ(answer["vessels"][0]["fields"][0]["map"], "grey");  // no solution
  EXPECT_EQ(answer["vessels"][0]["fields"][0]["title"], "axial stretch");
  EXPECT_FALSE(answer["plan"].is_null());
}

}  // namespace
}  // namespace vasorod::planner
