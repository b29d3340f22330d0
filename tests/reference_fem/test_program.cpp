// The built program vasorod-fem: exit codes, one sentence for unsupported scenes, the last
// converged state if a path ends, and equal results with two processes.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "program/run_program.h"

namespace vasorod::testing {
namespace {

const std::string head =
    "scene: bend\nfidelity: coupled\nunits: {length: mm, stress: MPa}\nvessels:\n"
    "  - {name: tube, tube: {length: 40, radius: 10}, wall: {thickness: 2, young: 1, poisson: "
    "0.3}}\n";
const std::string ends =
    "ends:\n  - {vessel: tube, end: start, hold: true}\n"
    "  - {vessel: tube, end: end, rotate_deg: [0, 8, 0], move: [2.8, 0, -0.1]}\n";

struct Solved {
  ProgramRun run;
  nlohmann::json json;
};

Solved solve(const std::string& scene, const std::string& options,
             const std::string& launcher = "") {
  const ScratchFolder scratch;
  std::ofstream(scratch / "scene.yaml") << scene;
  Solved out;
  out.run =
      run_program(launcher + " '" VASOROD_PROGRAM "' solve '" + (scratch / "scene.yaml").string() +
                  "' -o '" + (scratch / "result").string() + "' --quiet " + options);
  const std::string text = contents_of(scratch / "result/result.json");
  if (!text.empty()) out.json = nlohmann::json::parse(text);
  return out;
}

void refused(const std::string& scene, const std::string& part, const std::string& options = "") {
  const Solved r = solve(scene, options);
  EXPECT_EQ(r.run.exit_code, 2) << part;
  EXPECT_NE(r.run.err.find(part), std::string::npos) << r.run.err;
  EXPECT_EQ(std::count(r.run.err.begin(), r.run.err.end(), '\n'), 1) << r.run.err;
  EXPECT_TRUE(r.json.is_null());
}

/// The tube with more keys.
std::string tube_with(const std::string& keys) {
  std::string vessel = head;
  return vessel.replace(vessel.find("0.3}}"), 5, "0.3}, " + keys + "}");
}

TEST(FemProgram, RefusesWithOneSentenceAndNamesWhatItCanDo) {
  const std::string can = "the finite-element reference solves one generated tube (`tube:`)";
  const std::string other =
      "  - {name: other, tube: {length: 40, radius: 10, position: [50, 0, 0]}, wall: {thickness: "
      "2, young: "
      "1, "
      "poisson: 0.3}}\n";
  refused(head + other + ends, "found 2 vessels; " + can);
  refused(
      "scene: x\nfidelity: rod\nunits: {length: mm, stress: MPa}\nvessels:\n"
      "  - name: tube\n    rod: {position: [0,0,0], tangent: [0,0,1], normal: [1,0,0], pieces: "
      "[{length: 40, "
      "elements: 4}], stiffness: {axial: 1, shear: [1, 1], bending: [1, 1], torsion: 1}}\n" +
          ends,
      "found the bare rod \"tube\"; " + can);
  // each admissible alone, but not together: 1 - 0.3 - 2 * 0.3^2 * 100 < 0
  std::string wall = head;
  wall.replace(wall.find("young: 1, poisson: 0.3"), 22,
               "young: 0.01, shear: 0.4, transverse: {young: 1, poisson: 0.3, coupling: 0.3}");
  refused(wall + ends, "nu_LT");
  refused(tube_with("pressure: {scan: -0.001}") + ends, "scan");
  refused(tube_with("pressure: {scan: 1.3}") + ends, "which would stretch the wall by");
  refused(tube_with("axial_prestretch: 0.4") + ends, "axial_prestretch");
  refused(tube_with("axial_prestretch: 2.1") + ends, "axial_prestretch");
  refused(head + ends, "--model solid", "--law split-neo-hookean --model shell");
}

const std::string join =
    "scene: t\nfidelity: coupled\nunits: {length: mm, stress: MPa}\nvessels:\n"
    "  - {name: vein, tube: {length: 14, radius: 2}, wall: {thickness: 0.5, young: 0.5, poisson: "
    "0.4}, law: neo-hookean}\n"
    "  - {name: artery, tube: {length: 20, radius: 2.2, position: [-10, 0, 10.2], tangent: [1, 0, "
    "0], normal: [0, 0, 1]}, wall: {thickness: 0.5, young: 0.45, poisson: 0.4}, law: "
    "neo-hookean}\n"
    "ends:\n  - {vessel: vein, end: start, hold: true}\n"
    "  - {vessel: artery, end: start, hold: true}\n  - {vessel: artery, end: end, hold: true}\n"
    "contact: []\n"
    "surgery:\n  glenn: {svc: vein, rpa: artery, cut: [2, 0, 8], incision: [0, 0, 8], "
    "rotation_deg: 0, keep: {near: [0, 0, 0]}}\n";

TEST(FemProgram, JoinsTwoTubes) {
  const Solved r = solve(join, "--model shell --degree 2 --cells 8 0 --refine 1");
  ASSERT_EQ(r.run.exit_code, 0) << r.run.err;
  EXPECT_EQ(r.json["status"], "converged");
  EXPECT_EQ(r.json["fidelity"], "shell");
  EXPECT_EQ(r.json["vessels"].size(), 2u);
  EXPECT_EQ(r.json["ends"].size(), 3u);
  EXPECT_LT(r.json["glenn"]["join"]["largest_gap"].get<double>(), 1e-9);
  EXPECT_GT(r.json["glenn"]["mouth"]["area"].get<double>(), 0.1);
  EXPECT_GT(r.json["discretisation"]["error_estimate"].get<double>(), 0);
  const Solved two =
      solve(join, "--model shell --degree 2 --cells 8 0 --refine 1", VASOROD_MPIRUN " -n 2");
  ASSERT_EQ(two.run.exit_code, 0) << two.run.err;
  const double energy = r.json["energy"]["strain"];
  EXPECT_NEAR(two.json["energy"]["strain"].get<double>() / energy, 1, 1e-9);
  EXPECT_NEAR(two.json["glenn"]["mouth"]["area"].get<double>() /
                  r.json["glenn"]["mouth"]["area"].get<double>(),
              1, 1e-7);
  std::string touching = join;
  touching.replace(touching.find("contact: []\n"), 12, "");
  refused(touching, "the finite-element reference joins two straight generated tubes",
          "--model "
          "shell");
}

TEST(FemProgram, AMissingMeshFileIsAFilesError) {
  const Solved r = solve(head + ends, "--mesh /nowhere/wall.msh");
  EXPECT_EQ(r.run.exit_code, 3);
  EXPECT_NE(r.run.err.find("/nowhere/wall.msh"), std::string::npos) << r.run.err;
}

TEST(FemProgram, InputsInsideTheResultFolderAreKept) {
  const ScratchFolder scratch;
  std::ofstream(scratch / "scene.yaml") << head + ends;
  const ProgramRun run =
      run_program("'" VASOROD_PROGRAM "' solve '" + (scratch / "scene.yaml").string() + "' -o '" +
                  (scratch / "").string() + "' --quiet");
  EXPECT_EQ(run.exit_code, 3);
  EXPECT_NE(run.err.find("holds the input"), std::string::npos) << run.err;
  EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
  EXPECT_EQ(contents_of(scratch / "scene.yaml"), head + ends);
}

TEST(FemProgram, WhereThePathEndsTheLargestLoadIsWrittenWithExitCode1) {
  // S = C : E loses its strength in compression below 1 / sqrt(3)
  std::string crush = ends;
  crush.replace(crush.find("rotate_deg: [0, 8, 0], move: [2.8, 0, -0.1]"), 43,
                "move: [0, 0, -39.5]");
  const Solved r = solve(
      head + crush, "--law svk --degree 1 --refine 0 --cells 6 4 --arc-steps 4 --first-step 0.05");
  EXPECT_EQ(r.run.exit_code, 1);
  ASSERT_TRUE(r.json.is_object());
  EXPECT_EQ(r.json["status"], "iteration_limit");
  double load = -1;
  for (const std::string note : r.json["certificate"]["notes"])
    std::sscanf(note.c_str(), "the path ended at %lf", &load);
  EXPECT_GT(load, 0.05);
  EXPECT_LT(load, 0.9);
  EXPECT_NEAR(r.json["ends"][1]["center"][2].get<double>(), 40 - 39.5 * load, 1e-4);
}

TEST(FemProgram, TwoProcessesGiveTheNumbersOfOne) {
  // a soft end: multipliers and a free pose, so symmetric only in equilibrium
  const std::string soft =
      "ends:\n  - {vessel: tube, end: start, hold: true, section: soft}\n"
      "  - {vessel: tube, end: end, force: [0.1, 0, 0.3], section: soft}\n";
  const std::string stretched = tube_with("axial_prestretch: 1.03");
  for (const auto& [model, scene] : {std::pair<std::string, std::string>{"solid", head + ends},
                                     {"shell", head + soft},
                                     {"solid", stretched + soft},
                                     {"shell", stretched + ends}}) {
    const std::string options = "--degree 2 --refine 0 --cells 6 4 --model " + model;
    const Solved one = solve(scene, options), two = solve(scene, options, VASOROD_MPIRUN " -n 2");
    ASSERT_EQ(one.run.exit_code, 0) << one.run.err;
    ASSERT_EQ(two.run.exit_code, 0) << two.run.err;
    EXPECT_EQ(two.json["certificate"]["smallest_curvature_positive"], true);
    bool says = false;
    for (const std::string note : two.json["certificate"]["notes"])
      says = says || note == "solved by 2 processes";
    EXPECT_TRUE(says);
    const double energy = one.json["energy"]["strain"];
    EXPECT_NEAR(two.json["energy"]["strain"].get<double>(), energy, 1e-9 * energy);
    // One solve an iteration, and one factorisation more for the certificate.
    nlohmann::json counts = one.json["counts"], same = two.json["counts"];
    const int iterations = one.json["iterations"]["newton"];
    EXPECT_EQ(counts["solves"], iterations);
    EXPECT_EQ(counts["factorisations"], iterations + 1);
    EXPECT_GT(counts["hessians"], iterations);
    EXPECT_GE(counts["gradients"], counts["hessians"]);
    EXPECT_GT(counts["outer"], 0);
    // Each process has its order of elimination.
    EXPECT_GT(counts["factor_nonzeros"], 0);
    EXPECT_GT(same["factor_nonzeros"], 0);
    same["factor_nonzeros"] = counts["factor_nonzeros"];
    EXPECT_EQ(same, counts);
    double size = 0;
    for (int k = 0; k < 3; ++k)
      size = std::max(size, std::abs(one.json["ends"][0]["moment"][k].get<double>()));
    for (const char* what : {"force", "moment"})
      for (int k = 0; k < 3; ++k)
        EXPECT_NEAR(two.json["ends"][0][what][k].get<double>(),
                    one.json["ends"][0][what][k].get<double>(), 1e-8 * size);
  }
}

}  // namespace
}  // namespace vasorod::testing
