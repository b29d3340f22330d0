#include <vasorod/error.h>
#include <vasorod/read_scene.h>

#include "planner/small_scene.h"

namespace vasorod::planner {
namespace {

using OpenedSceneTest = SmallScene;

TEST_F(OpenedSceneTest, PicksBecomeFractions) {
  const auto scene = opened();
  ASSERT_TRUE(scene->plan);
  EXPECT_NEAR(scene->plan->cut_along, 35.0 / 40, 1e-3);  // kept from z = 45 down to z = 10
  EXPECT_NEAR(scene->plan->incision_along, 0.5, 1e-3);
  EXPECT_FALSE(scene->plan->ellipse_ratio);
  EXPECT_EQ(scene->part_of(0), "svc");
  EXPECT_EQ(scene->part_of(1), "rpa");
  EXPECT_EQ(refusal_of([&] { scene->vessel("none"); }).status, 404);
}

TEST_F(OpenedSceneTest, FractionsStayAsTheyWereWritten) {
  std::string text = with(small_scene, "[3.3, 0, 10]", "{along: 0.7123456789012345}");
  text = with(text, "[0, 0, 4]", "{along: 0.51, around_deg: -33.25}\n    rotation_deg: -7");
  const auto scene = opened(text);
  ASSERT_TRUE(scene->plan);
  EXPECT_EQ(scene->plan->cut_along, 0.7123456789012345);
  EXPECT_EQ(scene->plan->incision_along, 0.51);
  EXPECT_EQ(scene->plan->around_deg, -33.25);
  EXPECT_EQ(scene->plan->rotation_deg, -7);
}

TEST_F(OpenedSceneTest, APlanThatDidNotChangeChangesNoLine) {
  const auto scene = opened();
  const SceneEdit edit = edit_for(*scene, *scene->plan, "skin");
  EXPECT_TRUE(edit.glenn.empty());
  EXPECT_FALSE(edit.fidelity);
  EXPECT_EQ(edit_for(*scene, *scene->plan, "rod").fidelity, "rod");
}

TEST_F(OpenedSceneTest, TheSceneWithAPlanIsWhatTheFileWillBe) {
  const auto scene = opened();
  Plan plan = *scene->plan;
  plan.cut_along = 0.1 + 0.7;  // no short decimal
  plan.incision_along = 1.0 / 3;
  plan.around_deg = 12.5;
  plan.ellipse_ratio = 0.35;
  plan.rotation_deg = -3;
  plan.incision_length = 1.2;
  plan.cut_tilt_deg = -20;
  const Scene planned = with_plan(*scene, plan, "paper");
  const GlennSpec& glenn = *planned.glenn;
  EXPECT_EQ(glenn.cut.along, plan.cut_along);
  EXPECT_EQ(glenn.incision.along, plan.incision_along);
  EXPECT_EQ(glenn.incision.around_deg, plan.around_deg);
  EXPECT_EQ(glenn.ellipse->ratio, 0.35);
  EXPECT_EQ(glenn.rotation_deg, -3);
  EXPECT_EQ(glenn.incision_length, 1.2);
  EXPECT_EQ(glenn.cut_tilt_deg, -20);
  EXPECT_EQ(planned.fidelity, "paper");
  EXPECT_FALSE(glenn.incision.from);
  EXPECT_FALSE(glenn.incision.to);
  EXPECT_EQ(planned.vessels.size(), scene->scene.vessels.size());
}

TEST_F(OpenedSceneTest, RoutesAreTheScenesOrTheirOwn) {
  const auto scene = opened();
  Plan plan = *scene->plan;
  plan.incision_route = RouteEnds{1, 0};
  plan.incision_along = 0.4;
  const Scene planned = with_plan(*scene, plan, std::nullopt);
  ASSERT_TRUE(planned.glenn->incision.from);
  EXPECT_EQ(planned.glenn->incision.from->kind, EndSelector::Kind::end);
  plan.incision_route = RouteEnds{0, 9};
  EXPECT_EQ(refusal_of([&] { with_plan(*scene, plan, std::nullopt); }).status, 400);
  plan = *scene->plan;
  plan.cut_route = RouteEnds{scene->cut_route[1], scene->cut_route[0]};
  EXPECT_EQ(refusal_of([&] { with_plan(*scene, plan, std::nullopt); }).status, 400);
}

TEST_F(OpenedSceneTest, ScenesWithoutAPlanSayWhy) {
  const std::size_t surgery = small_scene.find("surgery:");
  const auto none = opened(small_scene.substr(0, surgery) + "fidelity: skin\n");
  EXPECT_FALSE(none->plan);
  EXPECT_NE(none->why_not.find("surgery"), std::string::npos);
  EXPECT_EQ(none->part_of(0), "");
  EXPECT_EQ(refusal_of([&] { edit_for(*none, Plan{}, std::nullopt); }).status, 400);
  const auto sized = opened(
      with(small_scene, "[0, 0, 4]", "[0, 0, 4]\n    incision_shape: {ellipse: {width: 2}}"));
  EXPECT_FALSE(sized->plan);
  EXPECT_NE(sized->why_not.find("ellipse"), std::string::npos);
  const auto off = opened(with(small_scene, "[0, 0, 4]", "[0, 40, 4]"));
  EXPECT_FALSE(off->plan);
  EXPECT_NE(off->why_not.find("off vessel"), std::string::npos) << off->why_not;
}

TEST_F(OpenedSceneTest, BareRodsAreRefused) {
  EXPECT_THROW(open_scene("s1", VASOROD_SOURCE_DIR "/benchmarks/cases/rod/b1-elastica.yaml"),
               InputError);
}

}  // namespace
}  // namespace vasorod::planner
