// Joins read from scenes: geometry, planes of symmetry, what is refused.
#include <Eigen/Geometry>
#include <cmath>
#include <cstdio>
#include <gtest/gtest.h>
#include <numbers>

#include <vasorod/error.h>

#include "reference_fem/join_problem.h"
#include "reference_fem/joined_tubes.h"

namespace vasorod::fem {
namespace {

constexpr double pi = std::numbers::pi;

JoinProblem read(const std::string& text) {
  return read_join(scene_of_text(text), std::nullopt);
}

Vec3 in_scene(const JoinProblem& problem, const Vec3& point) {
  return problem.units.length * (problem.frame * point);
}

Vec3 at(const JoinProblem& problem, const JoinWall& wall, double share, double fraction) {
  return in_scene(problem, wall.shape.point(wall.parameters(share, fraction)));
}

TEST(JoinProblem, RimAndSlitLieWhereTheSceneSays) {
  const JoinProblem problem = read(joined_tubes_text);
  EXPECT_EQ(problem.seam_side, 1);
  EXPECT_NEAR(problem.cut_fraction, 8.0 / 14, 1e-12);
  EXPECT_NEAR(problem.incision.length * problem.units.length, 2 * pi, 1e-12);
  // the vein comes from below, so the problem's z is the scene's -z
  EXPECT_LT((problem.frame.rotation.col(2) + Vec3::UnitZ()).norm(), 1e-12);
  EXPECT_LT((in_scene(problem, Vec3::Zero()) - Vec3(0, 0, 8)).norm(), 1e-12);
  const Vec3 tip = at(problem, problem.artery, 0, problem.incision.to);
  EXPECT_LT((tip - Vec3(pi, 0, 8)).norm(), 1e-12);
  EXPECT_LT((at(problem, problem.vein, 0, 1) - Vec3(2, 0, 8)).norm(), 1e-12);
  // a quarter on, rim and lip are both on the side of +y of the problem
  EXPECT_LT((at(problem, problem.vein, 0.25, 1) - Vec3(0, -2, 8)).norm(), 1e-12);
  EXPECT_LT(at(problem, problem.artery, 0.1, 0.5)[1], -1);
}

TEST(JoinProblem, SharesOfTheRimStartAtATip) {
  const JoinProblem problem = read(joined_tubes_text);
  const Incision& incision = problem.incision;
  const double quarter = incision.to - 0.25 * (incision.to - incision.from);
  EXPECT_NEAR(incision.rim_share({0, incision.to, 0.5}), 0, 1e-12);
  EXPECT_NEAR(incision.rim_share({1, incision.to, 0.5}), 0, 1e-12);
  EXPECT_NEAR(incision.rim_share({0, incision.from, 0.5}), 0.5, 1e-12);
  EXPECT_NEAR(incision.rim_share({0, quarter, 0.5}), 0.125, 1e-12);
  EXPECT_NEAR(incision.rim_share({1, quarter, 0.5}), 0.875, 1e-12);
  for (const double share : {0.0, 0.1, 0.5, 0.62, 0.99}) {
    EXPECT_NEAR(incision.rim_share(incision.rim_parameter(share)), share, 1e-12);
    // the rim runs along the slit at an even pace
    const Vec3 point = at(problem, problem.artery, incision.rim_parameter(share)[0],
                          incision.rim_parameter(share)[1]);
    EXPECT_NEAR(point[0], pi * (share <= 0.5 ? 1 - 4 * share : 4 * share - 3), 1e-12);
  }
}

TEST(JoinProblem, FindsThePlanesOfSymmetry) {
  const auto planes = [](const std::string& text) { return read(text).mirror; };
  using Planes = std::array<bool, 2>;
  const std::string& t = joined_tubes_text;
  EXPECT_EQ(planes(t), (Planes{true, true}));
  EXPECT_EQ(planes(with(t, "[-10, 0, 10.2]", "[-9, 0, 10.2]")), (Planes{false, true}));
  EXPECT_EQ(planes(with(t, "length: 20, radius: 2.2", "length: 20, radius: 2.2, end_radius: 2.1")),
            (Planes{false, true}));
  EXPECT_EQ(planes(with(t, "{vessel: artery, end: end, hold: true}",
                        "{vessel: vein, end: end, "
                        "hold: true}")),
            (Planes{false, true}));
  EXPECT_EQ(planes(with(t, "{length: 14, radius: 2}",
                        "{length: 14, radius: 2, position: [0, 0.1, "
                        "0]}")),
            (Planes{true, false}));
  EXPECT_EQ(planes(with(t, "rotation_deg: 0", "rotation_deg: 5")), (Planes{false, false}));
  EXPECT_EQ(planes(with(t, "{vessel: artery, end: end, hold: true}",
                        "{vessel: artery, end: end, move: [0.1, 0, 0]}")),
            (Planes{false, false}));
  EXPECT_EQ(planes(with(t, "vessel: vein, end: start, hold: true}",
                        "vessel: vein, end: start, hold: true, section: soft}")),
            (Planes{false, false}));
}

// The vein turned about the outward normal brings another point of its rim to the tip.
TEST(JoinProblem, ARotationShiftsTheRim) {
  const JoinProblem problem = read(with(joined_tubes_text, "rotation_deg: 0", "rotation_deg: 30"));
  const Vec3 rim = at(problem, problem.vein, 0, 1) - Vec3(0, 0, 8);
  const Vec3 outward = -Vec3::UnitZ();
  const Vec3 turned = Eigen::AngleAxisd(pi / 6, outward) * rim;
  EXPECT_LT((turned - Vec3(2, 0, 0)).norm(), 1e-12);
}

TEST(JoinProblem, TheOtherEndOfTheVeinMayBeKept) {
  std::string text = with(joined_tubes_text, "{length: 14, radius: 2}",
                          "{length: 14, radius: 2, position: [0, 0, 14], tangent: [0, 0, -1]}");
  text = with(text, "vessel: vein, end: start", "vessel: vein, end: end");
  const JoinProblem problem = read(text);
  EXPECT_EQ(problem.seam_side, 0);
  EXPECT_LT((at(problem, problem.vein, 0, 0) - Vec3(2, 0, 8)).norm(), 1e-12);
  EXPECT_LT((at(problem, problem.vein, 0.25, 0) - Vec3(0, -2, 8)).norm(), 1e-12);
  EXPECT_LT((at(problem, problem.vein, 0, 1) - Vec3(2, 0, 0)).norm(), 1e-12);
  EXPECT_EQ(problem.mirror, (std::array<bool, 2>{true, true}));
}

TEST(JoinProblem, ALongerIncisionIsLonger) {
  const JoinProblem problem =
      read(with(joined_tubes_text, "rotation_deg: 0", "incision_length: 1.25, rotation_deg: 0"));
  EXPECT_NEAR(problem.incision.length * problem.units.length, 1.25 * 2 * pi, 1e-12);
  const Vec3 a = at(problem, problem.artery, 0, problem.incision.from),
             b = at(problem, problem.artery, 0, problem.incision.to);
  EXPECT_NEAR((b - a).norm(), 1.25 * 2 * pi, 1e-12);
}

// By its ratio, its width or both axes; without a length its rim is as long as the cut's, 4 pi.
TEST(JoinProblem, AnEllipseHasTheSizeOfTheScene) {
  const auto opened = [](const std::string& shape) {
    return read(with(joined_tubes_text, "rotation_deg: 0", shape + ", rotation_deg: 0"));
  };
  const auto size = [](const JoinProblem& problem) -> Vec3 {
    const double unit = problem.units.length;
    return Vec3(problem.incision.length, 2 * problem.artery.hole->half_width,
                problem.incision.perimeter) *
           unit;
  };
  const Vec3 half = size(opened("incision_shape: {ellipse: 0.5}"));
  EXPECT_NEAR(half[1], 0.5 * half[0], 1e-12);
  EXPECT_NEAR(half[2], 4 * pi, 1e-9);
  // Ramanujan's second approximation, 1e-5 at this ratio.
  const double h = std::pow(0.5 / 1.5, 2), a = half[0] / 2;
  EXPECT_NEAR(pi * 1.5 * a * (1 + 3 * h / (10 + std::sqrt(4 - 3 * h))), 4 * pi, 1e-4);
  char width[32];
  std::snprintf(width, sizeof width, "%.15g", half[1]);
  EXPECT_LT((size(opened("incision_shape: {ellipse: {width: " + std::string(width) + "}}")) - half)
                .norm(),
            1e-9);
  const Vec3 both = size(opened("incision_shape: {ellipse: {length: 3, width: 4}}"));
  EXPECT_NEAR(both[0], 3, 1e-12);
  EXPECT_NEAR(both[1], 4, 1e-12);
  EXPECT_NEAR(size(opened("incision_shape: {ellipse: 0.5}, incision_length: 1.2"))[2], 4.8 * pi,
              1e-9);
}

TEST(JoinProblem, RefusesWhatItCannotDo) {
  const auto refused = [](const std::string& what, const std::string& by, const std::string& part) {
    try {
      read(with(joined_tubes_text, what, by));
      ADD_FAILURE() << "accepted: " << part;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
    }
  };
  refused("contact: []\n", "", "found no `contact: []`");
  refused("contact: []", "contact: [[vein, artery]]", "found a pair in `contact`");
  refused("{length: 14, radius: 2}", "{length: 14, radius: 2, bend_deg: 10}",
          "found the bent tube \"vein\"");
  refused("{length: 14, radius: 2}", "{length: 14, radius: 2, tangent: [0, 0.1, 1]}",
          "found an axis of the vein at 5.711 degrees to the incision's normal");
  refused("    law: neo-hookean\n  - name: artery",
          "    pressure: {scan: 0.001, after: 0.002}\n  - name: artery",
          "found 0.002 and 0 MPa in vein and artery, expected one pressure");
  refused("    law: neo-hookean\n  - name: artery", "    pressure: {scan: 0.2}\n  - name: artery",
          "vein: pressure.scan: found 0.2 MPa, which would stretch the wall by 140 %, expected at "
          "most 0.07143 MPa");
  refused("incision: [0, 0, 8]", "incision: [8, 0, 8]",
          "found an incision of length 6.283 that runs into an end of the artery");
  refused("rotation_deg: 0", "incision_shape: {ellipse: {length: 4, width: 5}}",
          "found an ellipse 4 long and 5 wide, which does not fit on the artery");
  refused("rotation_deg: 0", "incision_shape: {ellipse: {length: 24, width: 2}}",
          "found an ellipse 24 long and 2 wide, which does not fit on the artery");
  refused("rotation_deg: 0", "incision_shape: {ellipse: {width: 4.1}}",
          "found an ellipse 4.1 wide with a rim 12.57 long, which a circle exceeds");
  refused("rotation_deg: 0", "cut_tilt_deg: 20, rotation_deg: 0",
          "found an oblique cut (`cut_tilt_deg`)");
  refused("cut: [2, 0, 8]", "cut: {along: 0.5}", "found a pick by `along`");
  refused("cut: [2, 0, 8]", "cut: [2, 0, 17]", "glenn: cut: found a point 3 off vessel vein");
  refused("units: {length: mm, stress: MPa}\nvessels:\n",
          "units: {length: mm, stress: MPa}\nvessels:\n"
          "  - {name: other, tube: {length: 4, radius: 1, position: [50, 0, 0]}, wall: {thickness: "
          "0.1, young: 1, poisson: 0.3}}\n",
          "found 3 vessels beside a surgery");
  refused(
      "ends:\n  - {vessel: vein, end: start, hold: true}\n"
      "  - {vessel: artery, end: start, hold: true}\n"
      "  - {vessel: artery, end: end, hold: true}\n",
      "ends:\n  - {vessel: vein, end: start, force: [0, 0, 1e-6]}\n",
      "found 0 components held in all, expected at least 6, as the join");
}

// The kept part is a part of the vessel that was seen, held at both ends if it is cut, else where
// the scene says, or at both where it says nothing.
TEST(JoinProblem, KnowsTheVesselsAsTheyWereSeen) {
  const JoinProblem problem =
      read(with(joined_tubes_text, "  - {vessel: artery, end: start, hold: true}\n", ""));
  const JoinWall seen = as_seen(problem.vein);
  EXPECT_EQ(problem.vein.ends.size(), 1u);
  EXPECT_EQ(seen.ends.size(), 2u);
  EXPECT_NEAR(seen.shape.length, 7, 1e-12);
  EXPECT_NEAR(problem.vein.kept_from, 0, 1e-12);
  EXPECT_NEAR(problem.vein.kept_to, 8.0 / 14, 1e-12);
  for (const double fraction : {0.0, 0.4, 1.0})
    EXPECT_LT((problem.vein.shape.point(problem.vein.parameters(0.3, fraction)) -
               seen.shape.point(seen.parameters(0.3, fraction * problem.vein.kept_to)))
                  .norm(),
              1e-12);
  EXPECT_EQ(as_seen(problem.artery).ends.size(), 1u);
  const JoinProblem nowhere =
      read(with(with(joined_tubes_text, "  - {vessel: artery, end: start, hold: true}\n", ""),
                "  - {vessel: artery, end: end, hold: true}\n", ""));
  EXPECT_EQ(nowhere.artery.ends.size(), 0u);
  EXPECT_EQ(as_seen(nowhere.artery).ends.size(), 2u);
}

TEST(JoinProblem, EndToEndTheRimsPointsOfOneShareMeet) {
  const JoinProblem problem = read(end_to_end_text);
  ASSERT_TRUE(problem.other_rim);
  EXPECT_EQ(problem.seam_side, 1);
  EXPECT_NEAR(problem.cut_fraction, 8.0 / 14, 1e-12);
  EXPECT_EQ(problem.other_rim->side, 0);
  EXPECT_EQ(problem.other_rim->fraction, 1);
  EXPECT_NEAR(problem.units.length, 2, 1e-12);
  EXPECT_NEAR(problem.axis_turn, 0, 1e-12);
  // The second rim turns by 10 degrees about +z and is laid on the first, centre on centre.
  const Mat3 turn = Eigen::AngleAxisd(10 * pi / 180, Vec3::UnitZ()).toRotationMatrix();
  for (const double share : {0.0, 0.2, 0.7}) {
    const Vec3 first = at(problem, problem.vein, share, 1) - Vec3(0, 0, 8),
               second = at(problem, problem.artery, share, 0) - Vec3(0.2, 0, 8.5);
    EXPECT_LT((first / 2 - turn * second / 1.8).norm(), 1e-12) << share;
  }
  // The kept end of a cut tube without a condition is held, as is a whole tube's other end.
  const JoinProblem free =
      read(with(with(end_to_end_text, "  - {vessel: wide, end: start, hold: true}\n", ""),
                "{vessel: narrow, end: end, hold: true}", "{vessel: wide, end: end, hold: true}"));
  ASSERT_EQ(free.vein.ends.size(), 1u);
  EXPECT_EQ(free.vein.ends[0].side, 0);
  EXPECT_TRUE(free.vein.ends[0].held());
  ASSERT_EQ(free.artery.ends.size(), 1u);
  EXPECT_EQ(free.artery.ends[0].side, 1);
}

TEST(JoinProblem, EndToEndAtAnAngleTheSmallestTurnBringsTheRimsFaceToFace) {
  const JoinProblem problem = read(with(end_to_end_text, "position: [0.2, 0, 8.5]",
                                        "position: [0, 0, 8.5], tangent: [0, 0.6, 0.8]"));
  EXPECT_NEAR(problem.axis_turn, std::asin(0.6), 1e-12);
  const Mat3 turn = Eigen::AngleAxisd(10 * pi / 180, Vec3::UnitZ()).toRotationMatrix() *
                    Eigen::AngleAxisd(std::asin(0.6), Vec3::UnitX()).toRotationMatrix();
  for (const double share : {0.0, 0.3}) {
    const Vec3 first = at(problem, problem.vein, share, 1) - Vec3(0, 0, 8),
               second = at(problem, problem.artery, share, 0) - Vec3(0, 0, 8.5);
    EXPECT_LT((first / 2 - turn * second / 1.8).norm(), 1e-12) << share;
  }
}

TEST(JoinProblem, RefusesEndToEndWhatItDoesNotSolve) {
  const auto refused = [](const std::string& what, const std::string& by,
                          const std::string& words) {
    try {
      read(with(end_to_end_text, what, by));
      ADD_FAILURE() << words;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    }
  };
  refused("rotation_deg: 10", "rotation_deg: auto", "found `rotation_deg: auto`");
  refused("cut: [2, 0, 8]", "cut: [2, 0, 17]", "end_to_end: cut: found a point 3 off vessel wide");
  refused("cut: [2, 0, 8],", "cut: [2, 0, 8], cut_tilt_deg: 3,", "found an oblique cut");
  refused("vessel: narrow, end: end", "vessel: narrow, end: start",
          "a condition at the joined end of \"narrow\"");
  refused("radius: 1.8", "radius: 0.9", "differ by a factor of 2.222");
  refused("position: [0.2, 0, 8.5]", "position: [0, 0, 8.5], tangent: [0, 0.6, -0.8]",
          "degrees to face each other");
}

}  // namespace
}  // namespace vasorod::fem
