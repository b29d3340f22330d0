// Tubes that end in contact with themselves, through the built program. Each test takes about half
// a minute and is not among the default tests (label long).
#include <gtest/gtest.h>
#include <set>

#include "program/solved_scene.h"

namespace vasorod::testing {
namespace {

using nlohmann::json;

// The smooth branch is lost on the way, which the exit code says.
json solve(const std::string& scene) {
  return solved_scene("units: {length: mm, stress: MPa}\n" + scene + "fidelity: coupled\n", 1);
}

void expect_in_contact_with_itself(const json& result) {
  EXPECT_EQ(result.at("status"), "buckled") << result.at("certificate").dump();
  EXPECT_EQ(result.at("certificate").at("smallest_curvature_positive"), true);
  EXPECT_TRUE(result.at("self_intersections").empty());
  EXPECT_LT(result.at("balance")[0].at("residual").get<double>(), 1e-6);
  ASSERT_EQ(result.at("contact").size(), 1U);
  const json& contact = result.at("contact")[0];
  EXPECT_EQ(contact.at("a"), "tube");
  EXPECT_EQ(contact.at("b"), "tube");
  EXPECT_GT(contact.at("area").get<double>(), 0);
  EXPECT_NEAR(contact.at("smallest_gap").get<double>(), 0, 3e-3) << "2e-3 edges";
  // What is left of the lumen between walls that touch in the middle are two lobes.
  const double lumen = result.at("metrics")[0].at("smallest_lumen_ratio").get<double>();
  EXPECT_GT(lumen, 0.02);
  EXPECT_LT(lumen, 0.27095) << "the share at which opposite walls of a ring touch";
}

// Seven times the Brazier curvature, with the ends on the arc of the tube's length.
TEST(TouchesItself, AKinkPastBraziersLimit) {
  expect_in_contact_with_itself(
      solve("scene: kink\nvessels:\n"
            "  - name: tube\n    tube: {length: 60, radius: 10, around: 24, along: 24}\n"
            "    wall: {thickness: 1, young: 1.0, poisson: 0.3}\n"
            "ends:\n  - {vessel: tube, end: start, hold: true}\n"
            "  - {vessel: tube, end: end, rotate_deg: [0, 120, 0], "
            "move: [42.971835, 0, -35.190199]}\n"));
}

// Contacts of walls that crumple find no end: a barrier takes their place.
TEST(TouchesItself, AQuarterTurnBehindABarrier) {
  const json result = solve(
      "scene: twist\nvessels:\n"
      "  - name: tube\n    tube: {length: 100, radius: 10, around: 24, along: 44}\n"
      "    wall: {thickness: 1, young: 1.0, poisson: 0.3}\n"
      "ends:\n  - {vessel: tube, end: start, hold: true}\n"
      "  - {vessel: tube, end: end, rotate_deg: [0, 0, 90]}\n");
  EXPECT_EQ(result.at("status"), "buckled") << result.at("certificate").dump();
  EXPECT_TRUE(result.at("self_intersections").empty());
  EXPECT_NE(result.at("certificate").at("notes").dump().find("by a barrier"), std::string::npos);
  const json& contact = result.at("contact").at(0);
  EXPECT_GT(contact.at("area").get<double>(), 0);
  EXPECT_GT(contact.at("largest_pressure").get<double>(), 0);
  // Edges of 2.45 mm: the barrier is a tenth of it wide.
  EXPECT_GT(contact.at("smallest_gap").get<double>(), 0);
  EXPECT_LT(contact.at("smallest_gap").get<double>(), 0.245);
}

// Eight times the collapse pressure of a long tube: D = 1.306e-2 N mm, p_c = 3.92e-5 MPa.
TEST(TouchesItself, ATubeCollapsedByPressure) {
  expect_in_contact_with_itself(
      solve("scene: collapse\nvessels:\n"
            "  - name: tube\n    tube: {length: 80, radius: 10, around: 28, along: 40}\n"
            "    wall: {thickness: 0.5, young: 1.0, poisson: 0.45}\n"
            "    pressure: {scan: 0, after: -3.134796e-4}\n"
            "ends:\n  - {vessel: tube, end: start, hold: true}\n"
            "  - {vessel: tube, end: end, hold: true}\n"));
}

// Carried into the gap between two cylinders that narrows like a V, until its walls meet.
TEST(TouchesItself, ATubePressedFlatBetweenTwoObstacles) {
  const json result = solve(
      "scene: flat\nvessels:\n"
      "  - name: tube\n    tube: {length: 60, radius: 10, around: 28, along: 28}\n"
      "    wall: {thickness: 1, young: 1.0, poisson: 0.3}\n"
      "  - name: upper\n    role: obstacle\n"
      "    tube: {length: 100, radius: 6, around: 20, along: 60, "
      "position: [-35.48745, 25.43405, 30], tangent: [0.978148, -0.207912, 0], "
      "normal: [0, 0, 1]}\n    wall: {thickness: 1, young: 1.0, poisson: 0.3}\n"
      "  - name: lower\n    role: obstacle\n"
      "    tube: {length: 100, radius: 6, around: 20, along: 60, "
      "position: [-35.48745, -25.43405, 30], tangent: [0.978148, 0.207912, 0], "
      "normal: [0, 0, 1]}\n    wall: {thickness: 1, young: 1.0, poisson: 0.3}\n"
      "ends:\n  - {vessel: tube, end: start, move: [46, 0, 0]}\n"
      "  - {vessel: tube, end: end, move: [46, 0, 0]}\n");
  EXPECT_EQ(result.at("status"), "buckled") << result.at("certificate").dump();
  EXPECT_TRUE(result.at("self_intersections").empty());
  EXPECT_LT(result.at("balance")[0].at("residual").get<double>(), 1e-6);
  std::set<std::string> pressing;
  for (const json& contact : result.at("contact")) {
    EXPECT_GT(contact.at("area").get<double>(), 0) << contact;
    EXPECT_NEAR(contact.at("smallest_gap").get<double>(), 0, 3e-3) << contact;
    pressing.insert(contact.at("b"));
  }
  EXPECT_EQ(pressing, (std::set<std::string>{"tube", "upper", "lower"}));
  EXPECT_LT(result.at("metrics")[0].at("smallest_lumen_ratio").get<double>(), 0.27095);
}

}  // namespace
}  // namespace vasorod::testing
