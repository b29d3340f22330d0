// Bad input through the built program: it ends with exit code 2, prints one line, and leaves no
// result.
#include <algorithm>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <limits>

#include <vasorod/tube.h>

#include "program/run_program.h"
#include "program/small_glenn.h"
#include "surface_file/sample_surfaces.h"

namespace vasorod::testing {
namespace {

const std::string glenn = small_glenn("skin");

// One vessel from a file.
const std::string vessel = R"(scene: vessel
units: {length: mm, stress: MPa}
vessels:
  - name: tube
    surface: tube.vtp
    wall: {thickness: 1.0, young: 1.0, poisson: 0.3}
ends:
  - {vessel: tube, end: start, hold: true}
  - {vessel: tube, end: end, move: [0, 0, 1]}
fidelity: skin
)";

std::string changed(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  if (at == std::string::npos) throw std::logic_error("the test's scene does not hold " + from);
  return text.replace(at, from.size(), to);
}

void write(const std::filesystem::path& file, const std::string& text) {
  std::ofstream(file, std::ios::binary) << text;
}

class BadInput : public ::testing::Test {
 protected:
  ProgramRun solve(const std::string& scene) const {
    write(scratch / "scene.yaml", scene);
    return run_program(vasorod("solve '" + (scratch / "scene.yaml").string() + "' -o '" +
                               (scratch / "out").string() + "'"));
  }
  static void expect_one_line(const ProgramRun& run, int exit_code, const std::string& words) {
    EXPECT_EQ(run.exit_code, exit_code) << run.err;
    EXPECT_EQ(run.out, "");
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
    EXPECT_TRUE(run.err.ends_with('\n')) << run.err;
    EXPECT_NE(run.err.find(words), std::string::npos) << run.err;
  }
  void expect_refused(const std::string& scene, const std::string& words) const {
    expect_one_line(solve(scene), 2, words);
    EXPECT_FALSE(std::filesystem::exists(scratch / "out"));
  }
  void expect_surface_refused(const TriangleSurface& surface, const std::string& words) const {
    write_vtp(scratch / "tube.vtp", surface);
    expect_refused(vessel, words);
  }
  ScratchFolder scratch;
};

// The valid scene. If it failed, the refusals below could have other causes.
TEST_F(BadInput, TheGlennSceneItselfIsSolved) {
  const auto run = solve(glenn);
  EXPECT_LE(run.exit_code, 1) << run.err;
  EXPECT_TRUE(std::filesystem::exists(scratch / "out" / "result.json"));
}

TEST_F(BadInput, TheVesselSceneItselfIsSolved) {
  write_vtp(scratch / "tube.vtp", sample_tube());
  EXPECT_EQ(solve(vessel).exit_code, 0);
  EXPECT_TRUE(std::filesystem::exists(scratch / "out" / "result.json"));
}

TEST_F(BadInput, Usage) {
  expect_one_line(run_program(vasorod("")), 2, "vasorod");
  expect_one_line(run_program(vasorod("sovle x.yaml -o out")), 2, "vasorod");
  expect_one_line(run_program(vasorod("solve x.yaml")), 2, "output");
  expect_one_line(run_program(vasorod("solve --fidelity exact x.yaml -o out")), 2, "fidelity");
}

TEST_F(BadInput, MissingFiles) {
  expect_one_line(run_program(vasorod("solve '" + (scratch / "none.yaml").string() + "' -o '" +
                                      (scratch / "out").string() + "'")),
                  2, "none.yaml: found no such file");
  expect_refused(vessel, "tube.vtp: found no such file");
}

TEST_F(BadInput, EmptyAndTruncatedVtp) {
  write(scratch / "tube.vtp", "");
  expect_refused(vessel, "an empty file");
  for (const Encoding encoding : {Encoding::ascii, Encoding::appended_raw, Encoding::zlib}) {
    write_vtp(scratch / "whole.vtp", sample_tube(), encoding);
    const std::string whole = contents_of(scratch / "whole.vtp");
    write(scratch / "tube.vtp", whole.substr(0, whole.size() * 2 / 3));
    expect_refused(vessel, "a damaged or truncated file");
  }
}

TEST_F(BadInput, NonManifoldEdges) {
  TriangleSurface fin = sample_tube();
  const int tip = static_cast<int>(fin.points.rows());
  fin.points.conservativeResize(tip + 1, 3);
  fin.points.row(tip) << 20, 0, 20;
  fin.triangles.conservativeResize(fin.triangles.rows() + 1, 3);
  fin.triangles.row(fin.triangles.rows() - 1) << 240, 241, tip;
  expect_surface_refused(fin, "a non-manifold edge with 3 triangles at (");
}

TEST_F(BadInput, TwoComponents) {
  TriangleSurface other = sample_tube();
  other.points.col(0).array() += 30;
  expect_surface_refused(joined(sample_tube(), other), "2 separate parts");
}

TEST_F(BadInput, ClosedSurfaceWithoutEnds) {
  expect_surface_refused(closed_tube({0, 1}, 12), "a closed surface with no ends");
}

TEST_F(BadInput, InvertedOrientation) {
  TriangleSurface inverted = sample_tube();
  inverted.triangles.col(0).swap(inverted.triangles.col(1));
  expect_surface_refused(inverted, "an inverted surface");
}

TEST_F(BadInput, SelfIntersection) {
  TriangleSurface crossing = sample_tube();
  crossing.points.row(240) << -15, 0, 20;
  expect_surface_refused(crossing, "crosses itself");
}

// A surface of `around` x `rows` points around an axis, triangles counter-clockwise seen from
// outside if `at` (angle, share of the length) turns as (cos, sin) about its direction of
// increasing length.
TriangleSurface wound(int around, int rows, const std::function<Vec3(double, double)>& at) {
  TriangleSurface surface;
  surface.points.resize(around * (rows + 1), 3);
  surface.triangles.resize(2 * around * rows, 3);
  for (int row = 0; row <= rows; ++row)
    for (int i = 0; i < around; ++i)
      surface.points.row(row * around + i) =
          at(2 * M_PI * i / around, static_cast<double>(row) / rows);
  for (int row = 0; row < rows; ++row)
    for (int i = 0; i < around; ++i) {
      const int a = row * around + i, b = row * around + (i + 1) % around, t = 2 * a;
      surface.triangles.row(t) << a, b, a + around;
      surface.triangles.row(t + 1) << b, b + around, a + around;
    }
  return surface;
}

TEST_F(BadInput, SurfacesThatAreNotTubular) {
  expect_surface_refused(wound(48, 12,
                               [](double a, double v) {
                                 return Vec3((5 + 20 * v) * std::cos(a), (5 + 20 * v) * std::sin(a),
                                             0);
                               }),
                         "a flat surface that encloses nothing");
  // A shallow ring around a hole.
  expect_surface_refused(wound(48, 12,
                               [](double a, double v) {
                                 const double r = 11 - 6 * v;
                                 return Vec3(r * std::cos(a), r * std::sin(a),
                                             0.5 * std::sin(M_PI * v));
                               }),
                         "expected a tubular vessel");
  expect_surface_refused(closed_tube({0}, 12), "one open end");
}

// The section is a crescent whose centre lies in the hollow.
TEST_F(BadInput, ARodThatLeavesItsSurface) {
  expect_surface_refused(wound(96, 60,
                               [](double a, double v) {
                                 const double turn = 0.75 * M_PI * std::cos(a),
                                              r = 12 - 2 * std::sin(a);
                                 return Vec3(r * std::cos(turn), r * std::sin(turn), 100 * v);
                               }),
                         "outside the surface, expected a tubular vessel");
}

TEST_F(BadInput, SectionsLargerThanTheRadiusOfCurvature) {
  TubeSpec tube;
  tube.length = 32;  // half a circle of 10.2
  tube.radius = 10;
  tube.bend_deg = 180;
  tube.around = 80;
  tube.along = 60;
  expect_surface_refused(tube_surface(tube), " along the axis, near (");
  expect_surface_refused(tube_surface(tube), "sections reach the centre of curvature");
  expect_refused(changed(glenn, "length: 40, radius: 3.3", "length: 4, bend_deg: 90, radius: 3.3"),
                 "where the tube meets itself");
}

TEST_F(BadInput, WallsThickerThanTheRadius) {
  expect_refused(changed(glenn, "thickness: 0.4,", "thickness: 3.4,"),
                 "found a wall thicker than the tube's mid-wall radius");
  TubeSpec tube;
  tube.length = 60;
  tube.radius = 10;
  tube.end_radius = 4;
  write_vtp(scratch / "tube.vtp", tube_surface(tube));
  expect_refused(changed(vessel, "thickness: 1.0", "thickness: 6.0"),
                 "thick where the mid-wall radius is");
}

TEST_F(BadInput, CoefficientsAndModuliOutOfRange) {
  const std::string wall = "    wall: {thickness: 0.4, young: 0.5, poisson: 0.45}\n";
  for (const auto& [to, words] : std::vector<std::array<std::string, 2>>{
           {"    coefficients: {binding: 0, bending: 1, stretching: 1}\n",
            "coefficients.binding: found 0"},
           {"    coefficients: {binding: 1, bending: -1, stretching: 1}\n",
            "coefficients.bending: found -1"},
           {"    coefficients: {binding: 1, bending: 1, stretching: .inf}\n",
            "coefficients.stretching"}})
    expect_refused(changed(glenn, wall, wall + to), words);
  for (const auto& [to, words] : std::vector<std::array<std::string, 2>>{
           {"{thickness: 0.4, young: 1e31, poisson: 0.45}", "wall.young: found 1e+31"},
           {"{thickness: 0.4, young: 0.5, poisson: -1}", "wall.poisson: found -1"},
           {"{thickness: 0.4, young: 0.5, shear: 0, poisson: 0.3}", "wall.shear: found 0"},
           {"{thickness: 0.4, young: 0.5, shear: 0.2, transverse: {young: 5, poisson: 0.3, "
            "coupling: 0.3}}",
            "or the wall has no positive energy"}})
    expect_refused(changed(glenn, wall, "    wall: " + to + "\n"), words);
}

TEST_F(BadInput, PointsThatAreNoNumbers) {
  TriangleSurface broken = sample_tube();
  broken.points(17, 1) = std::numeric_limits<double>::quiet_NaN();
  expect_surface_refused(broken, "point 17");
}

TEST_F(BadInput, MetresDeclaredAsMillimetres) {
  TriangleSurface metres = sample_tube();
  metres.points /= 1000;
  expect_surface_refused(metres, "if the file is in m)");
}

TEST_F(BadInput, PicksOffTheirVessels) {
  expect_refused(changed(glenn, "cut: [3.3, 0, 10]", "cut: [12, 0, 10]"), "off vessel svc");
  expect_refused(changed(glenn, "incision: [0, 0, 4]", "incision: [0, 0, 12]"), "off vessel rpa");
}

TEST_F(BadInput, PicksByFractionAndMarkup) {
  const std::string cut = "cut: [3.3, 0, 10]", incision = "incision: [0, 0, 4]";
  for (const auto& [from, to, words] : std::vector<std::array<std::string, 3>>{
           {cut, "cut: 0.5", "cut: found \"0.5\", expected [x, y, z], {along: fraction} or"},
           {cut, "cut: {along: 1.1}", "cut.along: found 1.1, expected a number from 0 to 1"},
           {cut, "cut: {around_deg: 3}", "without along or markup"},
           {cut, "cut: {along: 0.5, around_deg: 3}", "the unknown key \"around_deg\""},
           {cut, "cut: {along: 0.5, to: {near: [0, 0, 45]}}", "found one end of the vessel"},
           {cut, "cut: {along: 0.5, to: {face: 2}}", "face: found 2, expected start, end or"},
           {cut, "cut: {along: 1}", "open end of the vessel"},
           {cut, "cut: {markup: none.json, label: a}", "none.json: found no such file"},
           {cut, "cut: {markup: scene.yaml, label: a}", "scene.yaml: found no JSON"},
           {cut, "cut: {markup: scene.yaml}", "cut.label: found nothing"},
           {incision, "incision: {along: 0.5}", "around_deg: found nothing"},
           {incision, "incision: {along: 0, around_deg: 0}", "expected"}})
    expect_refused(changed(glenn, from, to), words);
}

TEST_F(BadInput, AFaceThatNoLidHas) {
  const TriangleSurface closed = closed_tube({0, 1}, 0);
  NamedArray face{"ModelFaceID", {}, true, "Int32"};
  face.values.resize(closed.triangles.rows(), 1);
  face.values.setConstant(1);
  face.values.bottomRows(48).topRows(24).setConstant(2);
  face.values.bottomRows(24).setConstant(3);
  write_vtp(scratch / "tube.vtp", closed, Encoding::zlib, {}, {face});
  expect_refused(
      changed(vessel, "end: start", "end: {face: 4}"),
      ":8: face: found 4, expected the ModelFaceID of a lid over one of its ends: 2 or 3");
  const std::string faces =
      changed(changed(vessel, "end: start", "end: {face: 2}"), "end: end", "end: {face: 3}");
  EXPECT_EQ(solve(faces).exit_code, 0);
}

TEST_F(BadInput, ACutThatLeavesNothing) {
  expect_refused(changed(glenn, "cut: [3.3, 0, 10]", "cut: [3.3, 0, 44.9]"),
                 "open end of the vessel");
}

TEST_F(BadInput, AnIncisionLongerThanTheVessel) {
  // The slit is half the mouth's perimeter, 10.4 mm. The vessel is 9 mm long, or ends 2 mm beside
  // the pick.
  expect_refused(
      changed(glenn, "length: 50, radius: 4, around: 28, along: 60, position: [-25, 0, 0]",
              "length: 9, radius: 4, around: 28, along: 12, position: [-4.5, 0, 0]"),
      "incision");
  expect_refused(changed(glenn, "incision: [0, 0, 4]", "incision: [-23, 0, 4]"),
                 "open end of the vessel");
}

TEST_F(BadInput, ThingsTheSceneSaysWrongly) {
  const std::string wall = "thickness: 0.4, young: 0.5";
  for (const auto& [from, to, words] : std::vector<std::array<std::string, 3>>{
           {"fidelity: skin", "fidelty: skin", "\"fidelity\""},
           {"ends:", "end:", "\"ends\""},
           {wall, "thicknes: 0.4, young: 0.5", "\"thickness\""},
           {wall, "thickness: 0.4, young: soft", "\"soft\""},
           {wall, "thickness: [0.4], young: 0.5", "a list of 1"},
           {wall, "thickness: 0, young: 0.5", "vessels.svc.wall.thickness: found 0"},
           {wall, "thickness: -0.4, young: 0.5", "vessels.svc.wall.thickness: found -0.4"},
           {wall, "thickness: 0.4, young: 0", "vessels.svc.wall.young: found 0"},
           {wall, "thickness: 0.4, young: -0.5", "vessels.svc.wall.young: found -0.5"},
           {wall, "thickness: 0.4, young: 0.5, shear: -1", "vessels.svc.wall.shear: found -1"},
           {"poisson: 0.45", "poisson: 0.6", "at most 0.5"},
           {"hold: true", "hold: 7", "true or false"},
           {"vessel: svc", "vessel: scv", "\"svc\""},
           {"length: mm", "length: inch", "mm, cm or m"},
           {"scene: small-glenn", "scene: [", "YAML"},
           {"radius: 3.3", "radius: 3.3, bend_deg: 1e9", "bend_deg"},
           {"wall:", "pressure: 0.002\n    wall:", "a map of scan or after"},
           {"wall:", "pressure: {scan: 5}\n    wall:", "expected at most 242 mmHg"},
           {"wall:", "axial_prestretch: 2.5\n    wall:", "2.5"}})
    expect_refused(changed(glenn, from, to), words);
  expect_refused(
      changed(changed(glenn, "fidelity: skin", "fidelity: paper"),
              "wall:", "pressure: {scan: 0.001}\n    wall:"),
      "found a pressure at fidelity paper, expected fidelity rod, skin, section or coupled");
}

TEST_F(BadInput, SaysFileLineFieldFoundAndExpected) {
  const auto run = solve(changed(glenn, "young: 0.5", "young: -0.5"));
  EXPECT_NE(run.err.find((scratch / "scene.yaml").string() +
                         ":6: vessels.svc.wall.young: found -0.5, expected a number above 0\n"),
            std::string::npos)
      << run.err;
}

// Two names of one end. Only the fitted vessel shows that they mean the same end.
TEST_F(BadInput, TwoConditionsForOneEndUnderTwoNames) {
  write_vtp(scratch / "tube.vtp", sample_tube());
  for (const std::string second : {"move: [0, 0, 1]", "force: [0, 0, 1]", "fix: [x]"})
    expect_refused(
        changed(vessel, "end: end, move: [0, 0, 1]", "end: {near: [0, 0, -1]}, " + second),
        ":9: end: found near(0, 0, -1) of tube, the end that line 8 calls start");
}

TEST_F(BadInput, WhatTheRodRefusesHasFileLineAndVessel) {
  write_vtp(scratch / "tube.vtp", sample_tube());
  for (const auto& [to, words] : std::vector<std::array<std::string, 2>>{
           {"rotate_deg: [1e8, 0, 0]", "turn one element"}, {"force: [0, 0, 1]", "rigid motion"}}) {
    const std::string held = words == "rigid motion" ? "fix: [x]" : "hold: true";
    expect_refused(changed(changed(vessel, "move: [0, 0, 1]", to), "hold: true", held), words);
    EXPECT_NE(solve(changed(changed(vessel, "move: [0, 0, 1]", to), "hold: true", held))
                  .err.find("scene.yaml:4: vessel tube: "),
              std::string::npos);
  }
}

// A folder with other contents: exit code 3, and the folder does not change.
TEST_F(BadInput, AResultFolderThatIsNotOurs) {
  std::filesystem::create_directory(scratch / "out");
  write(scratch / "out" / "thesis.tex", "years of work");
  expect_one_line(solve(glenn), 3, "out");
  EXPECT_EQ(contents_of(scratch / "out" / "thesis.tex"), "years of work");
  EXPECT_FALSE(std::filesystem::exists(scratch / "out" / "result.json"));
}

TEST_F(BadInput, AResultFolderThatIsAFile) {
  write(scratch / "out", "years of work");
  expect_one_line(solve(glenn), 3, "out");
  EXPECT_EQ(contents_of(scratch / "out"), "years of work");
}

}  // namespace
}  // namespace vasorod::testing
