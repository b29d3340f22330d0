#include <cmath>

#include "planner/hand_made_result.h"
#include "planner/picks.h"
#include "planner/small_scene.h"

namespace vasorod::planner {
namespace {

using Picks = SmallScene;

TEST_F(Picks, TheFrontWallCountsAndNeverTheBack) {
  const auto scene = opened();
  // Down the y axis at z = 25: the wall at y = 3.3, inside it by at most the polygon's sagitta.
  const Json hit = pick_at_rest(*scene, {{0, 20, 25}, {0, -1, 0}}, {})["hit"];
  const double sagitta = 3.3 * (1 - std::cos(M_PI / 24));
  EXPECT_EQ(hit["vessel"], "svc");
  EXPECT_EQ(hit["part"], "svc");
  EXPECT_NEAR(hit["distance"].get<double>(), 20 - 3.3 + sagitta / 2, sagitta);
  EXPECT_NEAR(hit["along"].get<double>(), 20.0 / 40, 1e-3);
  EXPECT_FALSE(hit.contains("route"));
}

TEST_F(Picks, VesselsInFrontCanBeLeftOut) {
  const auto scene = opened();
  const Ray ray{{0.3, 20, 2}, {0, -1, 0}};
  EXPECT_EQ(pick_at_rest(*scene, ray, {})["hit"]["vessel"], "rpa");
  EXPECT_TRUE(pick_at_rest(*scene, ray, {"svc"})["hit"].is_null());
  EXPECT_EQ(refusal_of([&] { pick_at_rest(*scene, ray, {"none"}); }).status, 404);
}

TEST_F(Picks, ThePlaceIsThatOfAScene) {
  // What is picked, written into a scene, opens as the same fraction.
  const auto scene = opened();
  const Json hit = pick_at_rest(*scene, {{7, 3, 20}, {0, -0.1, -1}}, {"rpa"})["hit"];
  Plan plan = *scene->plan;
  plan.incision_along = hit["along"];
  plan.around_deg = hit["around_deg"];
  const std::vector<double> at = hit["point"];
  const Vec3 point(at[0], at[1], at[2]);
  const std::string text = with(small_scene, "[0, 0, 4]",
                                "[" + std::to_string(point.x()) + ", " + std::to_string(point.y()) +
                                    ", " + std::to_string(point.z()) + "]");
  const auto again = opened(text);
  EXPECT_NEAR(again->plan->incision_along, plan.incision_along, 1e-6);
  EXPECT_NEAR(again->plan->around_deg, plan.around_deg, 1e-4);
}

TEST_F(Picks, AResultAnswersWithItsFields) {
  const auto stored = hand_made();
  const Ray ray = read_ray(Body(R"({"origin": [1.5, 0.5, -7], "direction": [0, 0, 9]})"));
  const Json hit = pick_in_result(*stored, ray, {})["hit"];
  EXPECT_EQ(hit["vessel"], "square");
  EXPECT_NEAR(hit["distance"].get<double>(), 8, 1e-12);
  EXPECT_EQ(hit["triangle"], 0);
  // (1.5, 0.5) = 0.25 a + 0.5 b + 0.25 c with a (0, 0), b (2, 0), c (2, 2).
  EXPECT_NEAR(hit["weights"][0].get<double>(), 0.25, 1e-12);
  EXPECT_NEAR(hit["weights"][1].get<double>(), 0.5, 1e-12);
  EXPECT_NEAR(hit["weights"][2].get<double>(), 0.25, 1e-12);
  EXPECT_NEAR(hit["values"]["AxialStretch"].get<double>(), 1.15, 1e-12);
  EXPECT_NEAR(hit["values"]["ContactPressure"].get<double>(), 0.5 / 0.133322387415, 1e-9);
  const Json roof = pick_in_result(*stored, ray, {"roof"})["hit"];
  EXPECT_EQ(roof["vessel"], "roof");
  EXPECT_TRUE(roof["values"].empty());
  EXPECT_TRUE(pick_in_result(*stored, {{5, 5, 0}, {0, 0, 1}}, {})["hit"].is_null());
}

TEST_F(Picks, ADirectionOfNoLengthIsRefused) {
  const Body body(R"({"origin": [0, 0, 0], "direction": [0, 0, 0]})");
  EXPECT_EQ(refusal_of([&] { read_ray(body); }).status, 400);
}

}  // namespace
}  // namespace vasorod::planner
