// Picks by fraction and by markup, as a user would give them: the same operation as with points.
#include <algorithm>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <vasorod/read_scene.h>
#include <vasorod/tube.h>

#include "obj_text.h"
#include "program/run_program.h"
#include "program/small_glenn.h"

namespace vasorod::testing {
namespace {

using Json = nlohmann::json;

const std::string cut_point = "cut: [3.3, 0, 10]", incision_point = "incision: [0, 0, 4]";

std::string changed(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  if (at == std::string::npos) throw std::logic_error("the test's scene does not hold " + from);
  return text.replace(at, from.size(), to);
}

Vec3 vec3_of(const Json& value) {
  return {value[0].get<double>(), value[1].get<double>(), value[2].get<double>()};
}

class Picks : public ::testing::Test {
 protected:
  ProgramRun run(const std::string& scene) const {
    std::ofstream(scratch / "scene.yaml") << scene;
    return run_program(vasorod("solve '" + (scratch / "scene.yaml").string() + "' -o '" +
                               (scratch / "out").string() + "' --no-report --threads 1"));
  }
  Json solve(const std::string& scene) const {
    const ProgramRun done = run(scene);
    EXPECT_LE(done.exit_code, 1) << done.err;
    return Json::parse(contents_of(scratch / "out" / "result.json"), nullptr, false);
  }
  ScratchFolder scratch;
};

void expect_same_operation(const Json& a, const Json& b, double tolerance) {
  const Json &one = a["glenn"], &two = b["glenn"];
  EXPECT_NEAR(one["cut"]["fraction"].get<double>(), two["cut"]["fraction"].get<double>(),
              tolerance);
  EXPECT_LT((vec3_of(one["cut"]["plane"]["point"]) - vec3_of(two["cut"]["plane"]["point"])).norm(),
            tolerance);
  EXPECT_LT((vec3_of(one["incision"]["pick"]) - vec3_of(two["incision"]["pick"])).norm(),
            tolerance);
  for (int k = 0; k < 2; ++k)
    EXPECT_LT((vec3_of(one["incision"]["ends"][k]) - vec3_of(two["incision"]["ends"][k])).norm(),
              tolerance);
}

// The vein's axis runs from z = 45 (kept) to 5, the artery's along x with d1 = z and d2 = -y.
TEST_F(Picks, AFractionIsThePointThatItNames) {
  const std::string scene = small_glenn("skin");
  const Json points = solve(scene);
  EXPECT_NEAR(points["glenn"]["cut"]["fraction"].get<double>(), 0.875, 1e-9);
  EXPECT_EQ(vec3_of(points["glenn"]["cut"]["pick"]), Vec3(3.3, 0, 10));
  EXPECT_NEAR(points["glenn"]["incision"]["along"].get<double>(), 0.5, 1e-9);
  EXPECT_NEAR(points["glenn"]["incision"]["around_deg"].get<double>(), 0, 1e-6);
  const Json fractions = solve(changed(changed(scene, cut_point, "cut: {along: 0.875}"),
                                       incision_point, "incision: {along: 0.5, around_deg: 0}"));
  expect_same_operation(fractions, points, 1e-6);
  EXPECT_LT((vec3_of(fractions["glenn"]["cut"]["pick"]) - Vec3(0, 0, 10)).norm(), 1e-6);
  const Json turned =
      solve(changed(scene, incision_point, "incision: {along: 0.4, around_deg: 90, from: end}"));
  EXPECT_LT((vec3_of(turned["glenn"]["incision"]["pick"]) - Vec3(5, -4, 0)).norm(), 0.03);
}

// What result.json says of a pick is the same pick.
TEST_F(Picks, TheResultsFractionsAreTheSameOperation) {
  const std::string scene = changed(small_glenn("skin"), incision_point, "incision: [1.7, 2, 3.4]");
  const Json points = solve(scene);
  const Json& incision = points["glenn"]["incision"];
  const Json again = solve(changed(
      changed(scene, cut_point, "cut: {along: " + points["glenn"]["cut"]["fraction"].dump() + "}"),
      "incision: [1.7, 2, 3.4]",
      "incision: {along: " + incision["along"].dump() +
          ", around_deg: " + incision["around_deg"].dump() + "}"));
  expect_same_operation(again, points, 0.02);
}

// The tubes as surface files in RAS; the markups in both spaces, the signs of x and y flipped.
TEST_F(Picks, AMarkupIsReadInTheSpaceOfItsVessel) {
  std::ofstream(scratch / "tubes.yaml") << small_glenn("skin");
  std::string scene = small_glenn("skin");
  const Scene tubes = read_scene(scratch / "tubes.yaml");
  for (const VesselSpec& vessel : tubes.vessels) {
    TriangleSurface surface = tube_surface(*vessel.tube);
    surface.points.rowwise() += Eigen::RowVector3d(2, -30, 0);
    std::ofstream(scratch / (vessel.name + ".obj")) << "# SPACE=RAS\n" << obj_text(surface);
    const auto at = scene.find("tube: {", scene.find("name: " + vessel.name));
    scene.replace(at, scene.find('\n', at) - at, "surface: " + vessel.name + ".obj");
  }
  scene = changed(scene, "[0, 0, 45]", "[2, -30, 45]");
  const Json points = solve(changed(changed(scene, cut_point, "cut: [5.3, -30, 10]"),
                                    incision_point, "incision: [2, -30, 4]"));
  scene = changed(changed(scene, cut_point, "cut: {markup: picks.mrk.json, label: cut}"),
                  incision_point, "incision: {markup: picks.mrk.json, label: slit}");
  for (const auto& [system, sign] :
       {std::pair("\"RAS\"", 1), {"\"LPS\"", -1}, {"0", 1}, {"1", -1}}) {
    std::ofstream(scratch / "picks.mrk.json")
        << R"({"markups": [{"type": "Fiducial", "coordinateSystem": )" << system
        << R"(, "controlPoints": [{"label": "cut", "position": [)" << 5.3 * sign << ", "
        << -30 * sign << R"(, 10]}, {"label": "slit", "position": [)" << 2 * sign << ", "
        << -30 * sign << ", 4]}]}]}";
    const Json picked = solve(scene);
    expect_same_operation(picked, points, 1e-12);
    EXPECT_LT((vec3_of(picked["glenn"]["cut"]["pick"]) - Vec3(5.3, -30, 10)).norm(), 1e-12);
    EXPECT_EQ(picked["environment"]["inputs"].count("picks.mrk.json"), 1u);
  }
  const ProgramRun label = run(changed(scene, "label: slit", "label: slip"));
  EXPECT_EQ(label.exit_code, 2);
  EXPECT_NE(label.err.find("surgery.glenn.incision.label: found \"slip\", expected a label of "
                           "\"picks.mrk.json\": \"cut\" or \"slit\"\n"),
            std::string::npos)
      << label.err;
}

// The slit is 10.4 mm long and the artery begins at x = -25.
TEST_F(Picks, AnIncisionAtAnEndSaysHowFarToMove) {
  const std::string scene = small_glenn("skin");
  const ProgramRun refused = run(changed(scene, incision_point, "incision: [-23, 0, 4]"));
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_EQ(std::count(refused.err.begin(), refused.err.end(), '\n'), 1);
  double by = 0, x = 0, y = 0, z = 0;
  const auto at = refused.err.find("; moved by ");
  ASSERT_NE(at, std::string::npos) << refused.err;
  ASSERT_EQ(std::sscanf(refused.err.c_str() + at,
                        "; moved by %lf along the vessel, to (%lf, %lf, "
                        "%lf), it fits",
                        &by, &x, &y, &z),
            4)
      << refused.err;
  // At least half a slit from the end, at most a step (a tenth of slit and radius) and two rows of
  // triangles more.
  EXPECT_GT(x, -25 + 5.18);
  EXPECT_LT(x, -25 + 5.19 + 1.44 + 2 * 50.0 / 60);
  EXPECT_NEAR(x + 23, by, 0.02);
  solve(changed(scene, incision_point,
                "incision: [" + std::to_string(x) + ", " + std::to_string(y) + ", " +
                    std::to_string(z) + "]"));

  const ProgramRun along =
      run(changed(scene, incision_point, "incision: {along: 0.04, around_deg: 0}"));
  double fraction = 0;
  const auto to = along.err.find("to along: ");
  ASSERT_NE(to, std::string::npos) << along.err;
  ASSERT_EQ(std::sscanf(along.err.c_str() + to, "to along: %lf at", &fraction), 1);
  EXPECT_NEAR(fraction, (x + 25) / 50, 1e-3);
}

}  // namespace
}  // namespace vasorod::testing
