// What goes wrong outside the model: scenes that say nothing, numbers that are none, folders that
// hold what is not ours, signals, no memory.
#include <algorithm>
#include <csignal>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "program/run_program.h"
#include "program/running_program.h"
#include "program/small_glenn.h"

namespace vasorod::testing {
namespace {

namespace fs = std::filesystem;

const std::string source = VASOROD_SOURCE_DIR;

const std::string tube =
    "scene: pulled\nunits: {length: mm, stress: MPa}\nvessels:\n"
    "  - name: tube\n    tube: {length: 60, radius: 6, around: 16, along: 24}\n"
    "    wall: {thickness: 0.6, young: 1.0, poisson: 0.3}\n";
const std::string ends =
    "ends:\n  - {vessel: tube, end: start, hold: true}\n"
    "  - {vessel: tube, end: end, move: [0, 0, 1]}\n";

class Faults : public ::testing::Test {
 protected:
  std::string write(const std::string& name, const std::string& text) const {
    fs::create_directories((scratch / name).parent_path());
    std::ofstream(scratch / name) << text;
    return (scratch / name).string();
  }
  ProgramRun solve(const std::string& text, const std::string& options = "") const {
    return run_program(vasorod("solve '" + write("scene.yaml", text) + "' -o '" +
                               (scratch / "out").string() + "' " + options));
  }
  nlohmann::json result() const {
    return nlohmann::json::parse(contents_of(scratch / "out" / "result.json"));
  }
  static void expect_one_line(const ProgramRun& run, int exit_code, const std::string& words) {
    EXPECT_EQ(run.exit_code, exit_code) << run.err;
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
    EXPECT_NE(run.err.find(words), std::string::npos) << run.err;
  }
  // Nothing but `names` in a folder, hidden entries too.
  void expect_only(const std::vector<std::string>& names, const std::string& folder = "") const {
    std::vector<std::string> found;
    for (const auto& entry : fs::directory_iterator(scratch / folder))
      found.push_back(entry.path().filename().string());
    std::sort(found.begin(), found.end());
    EXPECT_EQ(found, names);
  }
  ScratchFolder scratch;
};

TEST_F(Faults, ASceneInWhichNothingWouldHappenIsRefused) {
  const std::string rod =
      "scene: rod\nunits: {length: mm, stress: MPa}\nvessels:\n"
      "  - {name: beam, rod: {position: [0, 0, 0], tangent: [1, 0, 0], normal: [0, 1, 0], pieces: "
      "[{length: 10, elements: 8}], stiffness: {axial: 100, shear: [100, 100], bending: [1, 1], "
      "torsion: 1}}}\nfidelity: rod\n";
  for (const std::string& scene :
       {tube + "fidelity: coupled\n", tube + "ends: []\nfidelity: rod\n", rod}) {
    expect_one_line(solve(scene), 2, "scene.yaml: found no condition in ends and no surgery");
    EXPECT_FALSE(fs::exists(scratch / "out"));
  }
}

TEST_F(Faults, APointFarOffEveryEndIsRefused) {
  std::string scene = tube + ends + "fidelity: rod\n";
  const std::string end = "end: end";
  scene.replace(scene.find(end), end.size(), "end: {near: [0, 0, 90]}");
  expect_one_line(solve(scene), 2,
                  "scene.yaml:9: near: found (0, 0, 90), 30 off the nearest end's");
  std::string glenn = small_glenn("rod");
  const std::string keep = "near: [0, 0, 45]";
  glenn.replace(glenn.find(keep), keep.size(), "near: [0, 0, 55]");
  expect_one_line(solve(glenn), 2, ": keep: near: found (0, 0, 55), 10 off the nearest end's");
}

TEST_F(Faults, NumbersThatMakeNoSenseAreRefused) {
  const std::string column =
      "scene: column\nunits: {length: mm, stress: MPa}\nvessels: [{name: column, rod: {position: "
      "[0, 0, 0], tangent: [1, 0, 0], normal: [0, 1, 0], pieces: [{length: 1e-320, elements: 8}], "
      "stiffness: {axial: 1e8, shear: [1e8, 1e8], bending: [1, 1], torsion: 1}}}]\n"
      "ends: [{vessel: column, end: start, hold: true}, {vessel: column, end: end, force: [-3.19, "
      "0, 0]}]\nfidelity: rod\n";
  std::string tree = contents_of(source + "/benchmarks/cases/rod/b13-tree.yaml");
  const std::string stiffness = "bending: [268.93910216339157, ";
  ASSERT_NE(tree.find(stiffness), std::string::npos);
  tree.replace(tree.find(stiffness), stiffness.size(), "bending: [1e308, ");
  std::string stretched = tube + ends + "fidelity: coupled\n";
  stretched.replace(stretched.find("length: 60"), 10, "length: 1e12");
  expect_one_line(solve(column), 2, "length: found ");
  expect_one_line(solve(tree), 2, "bending[0]: found 1e+308");
  expect_one_line(solve(stretched), 2, "tube.length: found 1e+12");
}

TEST_F(Faults, AnUnfinishedSolveSaysItsResidualAndWhy) {
  const auto run = solve(small_glenn("paper"), "--time-limit 1e-6");
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_NE(run.out.find("small-glenn: interrupted (paper), relative residual "), std::string::npos)
      << run.out;
  const std::string why = "stopped by the time limit of 1e-06 s at ";
  EXPECT_NE(run.out.find("\n  " + why), std::string::npos) << run.out;
  const std::string page = contents_of(scratch / "out" / "report.html");
  EXPECT_NE(page.find(why), std::string::npos);
  EXPECT_NE(page.find("best state so far, relative residual "), std::string::npos);
  EXPECT_NE(page.find("Validity: unknown"), std::string::npos);
}

TEST_F(Faults, InputsInsideTheResultFolderAreKept) {
  const std::string scene = write("p/scene.yaml", tube + ends + "fidelity: rod\n");
  const std::string out = (scratch / "p").string();
  expect_one_line(run_program(vasorod("solve '" + scene + "' -o '" + out + "'")), 3, "scene.yaml");
  expect_only({"scene.yaml"}, "p");
  // The same where a former result is there too.
  ASSERT_EQ(solve(tube + ends + "fidelity: skin\n").exit_code, 0);
  fs::rename(scratch / "out" / "result.json", scratch / "p" / "result.json");
  expect_one_line(run_program(vasorod("solve '" + scene + "' -o '" + out + "'")), 3, "scene.yaml");
  expect_only({"result.json", "scene.yaml"}, "p");
  // A surface has a name that a result's file may have.
  const std::string surface = (scratch / "out" / "tube.vtp").string();
  fs::rename(scratch / "p" / "result.json", scratch / "out" / "result.json");
  const std::string before = contents_of(surface);
  expect_one_line(
      run_program(vasorod("fit '" + surface + "' -o '" + (scratch / "out").string() + "'")), 3,
      "holds the input");
  expect_one_line(solve("scene: s\nunits: {length: mm, stress: MPa}\nvessels:\n  - {name: tube, "
                        "surface: out/tube.vtp, wall: {thickness: 0.6, young: 1, poisson: 0.3}}\n" +
                        ends + "fidelity: rod\n"),
                  3, "holds the input");
  EXPECT_EQ(contents_of(surface), before);
}

TEST_F(Faults, AForeignFileInAFormerResultIsKept) {
  ASSERT_EQ(solve(tube + ends + "fidelity: rod\n").exit_code, 0);
  write("out/thesis.tex", "years of work");
  expect_one_line(solve(tube + ends + "fidelity: rod\n"), 3, "holds \"thesis.tex\"");
  EXPECT_EQ(contents_of(scratch / "out" / "thesis.tex"), "years of work");
  fs::remove(scratch / "out" / "thesis.tex");
  EXPECT_EQ(solve(tube + ends + "fidelity: rod\n").exit_code, 0);
}

TEST_F(Faults, TheFirstSignalWritesTheBestStateSoFar) {
  for (const int signal : {SIGHUP, SIGINT, SIGTERM}) {
    const std::string out = (scratch / "out").string();
    RunningProgram program({"solve", write("scene.yaml", small_glenn("coupled")), "-o", out});
    program.send(signal);
    EXPECT_EQ(program.wait(), 1);
    EXPECT_EQ(result().at("status"), "interrupted");
    const auto notes = result().at("certificate").at("notes");
    EXPECT_EQ(notes.back().get<std::string>().rfind("stopped by a signal at ", 0), 0U) << notes;
    fs::remove_all(out);
  }
}

// Long before it has read its vessels.
TEST_F(Faults, TheSecondSignalEndsAtOnceAndLeavesNothing) {
  RunningProgram program(
      {"solve", source + "/benchmarks/cases/glenn/infant.yaml", "-o", (scratch / "out").string()});
  program.send(SIGINT);
  program.send(SIGINT);
  EXPECT_EQ(program.wait(), 130);
  expect_only({});
}

TEST_F(Faults, FitEndsAtTheFirstSignal) {
  RunningProgram program(
      {"fit", source + "/meshes/infant/aorta.vtp", "-o", (scratch / "out").string()});
  program.send(SIGTERM);
  EXPECT_EQ(program.wait(), 128 + SIGTERM);
  expect_only({});
}

TEST_F(Faults, NoMemoryIsOneSentenceAndThree) {
  if (!addresses_can_be_limited) GTEST_SKIP() << "the address sanitizer reserves terabytes";
  std::string scene = tube + ends + "fidelity: skin\n";
  const std::string mesh = "around: 16, along: 24";
  scene.replace(scene.find(mesh), mesh.size(), "around: 1400, along: 1400");
  const std::string command =
      vasorod("solve '" + write("scene.yaml", scene) + "' -o '" + (scratch / "out").string() + "'");
  const auto run = run_program("ulimit -v 1000000; OPENBLAS_NUM_THREADS=1 " + command);
  expect_one_line(run, 3, "memory");
  expect_only({"scene.yaml"});
}

}  // namespace
}  // namespace vasorod::testing
