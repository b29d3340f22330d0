#include "planner/hand_made_result.h"
#include "planner/scene_answer.h"
#include "planner/small_scene.h"

namespace vasorod::planner {
namespace {

using SceneAnswer = SmallScene;

TEST_F(SceneAnswer, AxesAreWhereThePlanCounts) {
  const Json answer = scene_answer(*opened());
  EXPECT_EQ(answer["name"], "small");
  EXPECT_EQ(answer["kind"], "scene");
  EXPECT_EQ(answer["units"]["length"], "mm");
  EXPECT_EQ(answer["fidelity"], "skin");
  EXPECT_EQ(
      answer["limits"].dump(),
      R"({"incision_length":[0.25,4.0],"cut_tilt_deg":[-75.0,75.0],"ellipse_ratio":[0.1,1.0]})");
  ASSERT_EQ(answer["vessels"].size(), 2U);
  for (const Json& place : answer["vessels"][0]["axis"]) {
    const double along = place["along"];
    EXPECT_NEAR(place["point"][0].get<double>(), 0, 1e-3);
    EXPECT_NEAR(place["point"][2].get<double>(), 45 - 40 * along, 1e-2);  // from the kept end
    EXPECT_NEAR(place["radius"].get<double>(), 3.3, 0.03);
  }
  for (const Json& place : answer["vessels"][1]["axis"])
    EXPECT_NEAR(place["point"][0].get<double>(), -25 + 50 * place["along"].get<double>(), 1e-2);
  const Json& ends = answer["vessels"][0]["ends"];
  ASSERT_EQ(ends.size(), 2U);
  EXPECT_NEAR(ends[0]["centre"][2].get<double>(), 5, 1e-3);
  EXPECT_NEAR(ends[0]["normal"][2].get<double>(), -1, 1e-3);
}

TEST_F(SceneAnswer, ASceneWithoutAnOperationCannotBeEdited) {
  const std::size_t surgery = small_scene.find("surgery:");
  const Json answer = scene_answer(*opened(small_scene.substr(0, surgery) + "fidelity: skin\n"));
  EXPECT_FALSE(answer["editable"].get<bool>());
  EXPECT_TRUE(answer["why_not"].is_string());
  EXPECT_TRUE(answer["plan"].is_null());
  EXPECT_TRUE(answer["vessels"][0]["part"].is_null());
  EXPECT_TRUE(answer["vessels"][0]["axis"].empty());
}

TEST_F(SceneAnswer, AResultIsForLooking) {
  const Json answer = result_answer("s2", "hand-made", *hand_made());
  EXPECT_EQ(answer["kind"], "result");
  EXPECT_EQ(answer["result"], "r1");
  EXPECT_EQ(answer["units"]["stress"], "kPa");
  EXPECT_FALSE(answer["editable"].get<bool>());
  EXPECT_EQ(answer["vessels"][1]["role"], "obstacle");
}

}  // namespace
}  // namespace vasorod::planner
