#include <cmath>
#include <gtest/gtest.h>

#include "geometry/triangle_surface.h"
#include "predict/name_crossings.h"
#include "predict/small_scenes.h"
#include "straight_tube.h"

namespace vasorod {
namespace {

using namespace testing;
using Kind = EndSelector::Kind;

// A tube of length 36 and radius 6 with its end turned by `degrees` and moved.
Scene turned(const std::string& fidelity, double degrees, const Vec3& by) {
  Scene scene;
  scene.name = "turned";
  scene.vessels = {tube("vein", 36)};
  scene.ends = {held("vein", Kind::start), moved("vein", Kind::end, by)};
  scene.ends[1].rotate_deg = Vec3(0, degrees, 0);
  scene.fidelity = fidelity;
  return scene;
}
// Folded back: the end stands beside the start, nearer than two radii.
Scene folded(const std::string& fidelity) {
  return turned(fidelity, 180, {9, 0, -33});
}

// The warning of the vein's crossing with itself; empty: none.
std::string warning(const Result& result) {
  for (const std::string& warning : result.validity.warnings)
    if (warning.find("vein passes through itself") != std::string::npos) return warning;
  return "";
}
bool warns(const Result& result) {
  return !warning(result).empty();
}

TEST(NameCrossings, ASolvedWallInsideItselfDoesNotConverge) {
  const Result result = predict(folded("paper"));
  EXPECT_EQ(result.status, Status::self_intersecting) << to_string(result.status);
  ASSERT_EQ(result.self_intersections.size(), 1U);
  const SelfIntersection& crossing = result.self_intersections[0];
  EXPECT_EQ(crossing.a, "vein");
  EXPECT_EQ(crossing.b, "vein");
  EXPECT_GT(crossing.pairs, 10);
  EXPECT_GT(crossing.depth, 0.5);
  EXPECT_FALSE(result.validity.in_range);
  EXPECT_TRUE(warning(result).ends_with("the wall did not feel itself")) << warning(result);
}

TEST(NameCrossings, WhatWasFoundOnceIsNotSearchedAgain) {
  Scene scene;
  Prediction prediction;
  prediction.scene = &scene;
  PredictedVessel& vein = prediction.vessels.emplace_back();
  vein.prepared.spec.name = "vein";
  vein.prepared.vessel.surface = tube_surface(straight_tube(36, 6, 24, 24));
  vein.prepared.vessel.mean_radius = 6;
  vein.positions = vein.prepared.vessel.surface.points;
  EXPECT_EQ(deepest_crossing(prediction), 0);
  ASSERT_TRUE(prediction.crossings);
  EXPECT_TRUE(prediction.crossings->empty());
  for (auto point : vein.positions.rowwise())  // the second half pushed into the first
    if (point.z() > 18) point += Vec3(1, 0, 36 - 2 * point.z()).transpose();
  EXPECT_EQ(deepest_crossing(prediction), 0) << "it is told of no motion";
  prediction.crossings.reset();
  const double depth = deepest_crossing(prediction);
  EXPECT_GT(depth, 0.1);
  ASSERT_EQ(prediction.crossings->size(), 1U);
  prediction.crossings->front().crossing.depth *= 2;
  Result result;
  name_crossings(prediction, result);
  ASSERT_EQ(result.self_intersections.size(), 1U);
  EXPECT_EQ(result.self_intersections[0].depth, 2 * depth);
}

TEST(NameCrossings, ACarriedWallIsOnlyWarnedOf) {
  const Result result = predict(folded("skin"));
  EXPECT_EQ(result.status, Status::converged);
  EXPECT_EQ(result.self_intersections.size(), 1U);
  EXPECT_TRUE(warns(result));
  EXPECT_FALSE(result.validity.in_range);
  EXPECT_TRUE(warning(result).ends_with("fidelity skin models no contact")) << warning(result);
  const Result rods = predict(folded("rod"));  // the same walls, carried by its rods
  EXPECT_EQ(rods.status, Status::converged);
  ASSERT_EQ(rods.self_intersections.size(), 1U);
  EXPECT_EQ(rods.self_intersections[0].depth, result.self_intersections[0].depth);
  EXPECT_TRUE(warning(rods).ends_with("fidelity rod models no contact")) << warning(rods);
}

// Mid-wall radius 6, axes 14 apart; one moves by 4: walls 2 deep in each other.
TEST(NameCrossings, OfTwoVesselsWithoutContactThatIsTheReason) {
  Scene scene;
  scene.name = "two";
  scene.vessels = {tube("vein", 36), tube("artery", 36, {14, 0, 0})};
  scene.ends = {moved("vein", Kind::start, {4, 0, 0}), moved("vein", Kind::end, {4, 0, 0}),
                held("artery", Kind::start), held("artery", Kind::end)};
  scene.fidelity = "skin";
  const Result result = predict(scene);
  ASSERT_EQ(result.self_intersections.size(), 1U);
  EXPECT_NEAR(result.self_intersections[0].depth, 2, 0.05);
  EXPECT_TRUE(result.validity.warnings[0].starts_with("vein and artery pass through each other"))
      << result.validity.warnings[0];
  EXPECT_TRUE(result.validity.warnings[0].ends_with("fidelity skin models no contact"))
      << result.validity.warnings[0];
}

TEST(NameCrossings, ABendIsNone) {
  for (const std::string fidelity : {"rod", "skin", "paper", "coupled"}) {
    const Result result = predict(turned(fidelity, 10, {3, 0, -0.3}));
    EXPECT_TRUE(result.self_intersections.empty()) << fidelity;
    EXPECT_FALSE(warns(result)) << fidelity;
    EXPECT_NE(result.status, Status::self_intersecting) << fidelity;
  }
}

TEST(NameCrossings, InterruptedStatesAreNotSearched) {
  SolveOptions options;
  options.stop = [] { return true; };
  const Result result = predict(folded("paper"), options);
  EXPECT_EQ(result.status, Status::interrupted) << to_string(result.status);
  EXPECT_TRUE(result.self_intersections.empty());
}

}  // namespace
}  // namespace vasorod
