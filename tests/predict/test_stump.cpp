// What a Glenn operation leaves of its vein is in the way of the vessels that are joined.
#include <gtest/gtest.h>

#include "predict/t_glenn.h"

namespace vasorod {
namespace {

using namespace testing;

// The artery passes half a unit beside the stump, and the vein's tension draws it over the cap.
Scene beside_the_stump() {
  Scene scene = t_glenn(24, 12.5);
  scene.vessels[0].tube->along = 48;
  scene.vessels[1].tube->along = 60;
  scene.vessels[1].tube->position.z() = 14;
  scene.glenn->incision.point = Vec3(0, 8.3, 18.2);
  return scene;
}

SolveOptions at(const std::string& fidelity) {
  SolveOptions options;
  options.fidelity = fidelity;
  return options;
}

const ContactReport* between(const Result& result, const std::string& a, const std::string& b) {
  for (const ContactReport& pair : result.contact)
    if (pair.a == a && pair.b == b) return &pair;
  return nullptr;
}

TEST(Stump, KeepsTheArteryOut) {
  const Result result = predict(beside_the_stump(), at("coupled"));
  EXPECT_EQ(result.status, Status::converged) << to_string(result.status);
  EXPECT_TRUE(result.self_intersections.empty());
  const ContactReport* pressed = between(result, "artery", "vein_stump");
  ASSERT_NE(pressed, nullptr);
  EXPECT_GT(pressed->largest_pressure, 0);
  EXPECT_GT(pressed->force.y(), 0) << "away from the stump";
  ASSERT_NE(between(result, "vein", "vein_stump"), nullptr);
  // Nothing else presses on the artery, whose forces balance.
  for (const Balance& vessel : result.balance) {
    EXPECT_LT(vessel.residual, 1e-6);
    if (vessel.vessel == "artery") {
      EXPECT_LT((vessel.contact - pressed->force).norm(), 1e-6 * pressed->force.norm());
    }
  }
  // The stump is the vein's, not a vessel of its own.
  ASSERT_EQ(result.vessels.size(), 2U);
  EXPECT_TRUE(result.vessels[0].stump.has_value());
}

TEST(Stump, IsNamedWhereTheArteryPassesThroughIt) {
  Scene scene = beside_the_stump();
  scene.contact.emplace();
  for (const char* fidelity : {"coupled", "paper"}) {
    const Result result = predict(scene, at(fidelity));
    EXPECT_EQ(result.status, Status::self_intersecting) << fidelity;
    ASSERT_EQ(result.self_intersections.size(), 1U) << fidelity;
    EXPECT_EQ(result.self_intersections[0].a, "artery");
    EXPECT_EQ(result.self_intersections[0].b, "vein_stump");
    EXPECT_GT(result.self_intersections[0].depth, 0.3);
  }
}

TEST(Stump, IsTouchedByWhatMayTouchTheVein) {
  Scene scene = beside_the_stump();
  scene.contact.emplace().push_back({"vein", "artery"});
  const Result result = predict(scene, at("paper"));
  EXPECT_EQ(result.status, Status::converged) << to_string(result.status);
  EXPECT_NE(between(result, "artery", "vein_stump"), nullptr);
  EXPECT_EQ(between(result, "vein", "vein_stump"), nullptr);
}

TEST(Stump, OfASketchIsOutOfTheWay) {
  const Result result = predict(t_glenn(24, 2), at("paper"));
  EXPECT_EQ(result.status, Status::converged) << to_string(result.status);
  EXPECT_EQ(between(result, "artery", "vein_stump"), nullptr);
  EXPECT_TRUE(result.model.left_out.contains("stump of vein"));
  EXPECT_FALSE(predict(beside_the_stump(), at("skin")).model.left_out.contains("stump of vein"));
}

}  // namespace
}  // namespace vasorod
