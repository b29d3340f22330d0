// A time limit reaches every stage of a solve, and scenes too large for the memory are refused. A
// program that does not listen is ended by `timeout`, with exit code 124.
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "program/run_program.h"
#include "program/small_glenn.h"

namespace vasorod::testing {
namespace {

namespace fs = std::filesystem;

const std::string source = VASOROD_SOURCE_DIR;

class TimeLimit : public ::testing::Test {
 protected:
  // Ended after `patience` seconds. `before`: what the shell does first.
  ProgramRun solve(const std::string& scene, const std::string& options, int patience,
                   const std::string& before = "") const {
    return run_program(
        before + "timeout -k 1 " + std::to_string(patience) + " " +
        vasorod("solve '" + scene + "' -o '" + (scratch / "out").string() + "' " + options));
  }
  std::string write(const std::string& text) const {
    std::ofstream(scratch / "scene.yaml") << text;
    return (scratch / "scene.yaml").string();
  }
  // One sentence and no result, or a result that says that it was interrupted.
  void expect_interrupted(const ProgramRun& run) const {
    EXPECT_EQ(run.exit_code, 1) << run.err;
    if (!fs::exists(scratch / "out")) {
      EXPECT_NE(run.err.find("nothing is written"), std::string::npos) << run.err;
      EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
      return;
    }
    const auto result = nlohmann::json::parse(contents_of(scratch / "out" / "result.json"));
    EXPECT_EQ(result.at("status"), "interrupted");
    const std::string why = result.at("certificate").at("notes").back();
    EXPECT_EQ(why.rfind("stopped by the time limit of ", 0), 0U) << why;
    EXPECT_NE(run.out.find(why), std::string::npos) << run.out;
    EXPECT_TRUE(fs::exists(scratch / "out" / "report.html"));
  }
  ScratchFolder scratch;
};

TEST_F(TimeLimit, AHundredthOfASecondEndsAnOperationOnAnatomy) {
  for (const std::string fidelity : {"paper", "coupled"}) {
    expect_interrupted(solve(source + "/benchmarks/cases/glenn/infant.yaml",
                             "--time-limit 0.01 --fidelity " + fidelity, 60));
    fs::remove_all(scratch / "out");
  }
}

// A tube of 160,000 vertices: its ordering alone takes longer than the limit and the patience, and
// cannot be stopped inside.
TEST_F(TimeLimit, AFactorisationIsCutAndTheStateBeforeItWritten) {
  const std::string scene = write(
      "scene: fine\nunits: {length: mm, stress: MPa}\nvessels:\n"
      "  - name: tube\n    tube: {length: 60, radius: 6, around: 400, along: 399}\n"
      "    wall: {thickness: 0.6, young: 1.0, poisson: 0.3}\n"
      "ends:\n  - {vessel: tube, end: start, hold: true}\n"
      "  - {vessel: tube, end: end, move: [0, 0, 1]}\nfidelity: paper\n");
  expect_interrupted(solve(scene, "--time-limit 3", 120));
}

// Reading chained rods took time cubic in their number.
TEST_F(TimeLimit, ThousandsOfChainedRodsAreReadAndSolved) {
  constexpr int rods = 4000;
  std::string scene = "scene: chain\nunits: {length: mm, stress: MPa}\nvessels:\n";
  for (int i = 0; i < rods; ++i)
    scene += "  - {name: r" + std::to_string(i) + ", rod: {" +
             (i == 0 ? "position: [0, 0, 0], tangent: [1, 0, 0], normal: [0, 1, 0]"
                     : "parent: r" + std::to_string(i - 1)) +
             ", pieces: [{length: 1, elements: 1}], stiffness: {axial: 1e4, shear: [1e4, 1e4], "
             "bending: [1e4, 1e4], torsion: 1e4}}}\n";
  scene += "ends: [{vessel: r0, end: start, hold: true}, {vessel: r" + std::to_string(rods - 1) +
           ", end: end, force: [0, 1e-9, 0]}]\nfidelity: rod\n";
  const auto run = solve(write(scene), "--json", 200);
  ASSERT_EQ(run.exit_code, 0) << run.err;
  // A cantilever's tip under a small load: F L^3 / (3 EI) + F L / GA.
  const double length = rods, tip = 1e-9 * (std::pow(length, 3) / 3 + length) / 1e4;
  const auto result = nlohmann::json::parse(run.out);
  EXPECT_NEAR(result.at("ends").at(1).at("center").at(1).get<double>(), tip, 1e-6 * tip);
}

TEST_F(TimeLimit, ASceneThatTheMemoryCannotHoldIsRefusedBeforeItIsRead) {
  const std::string scene = write(
      "scene: vast\nunits: {length: mm, stress: MPa}\nvessels:\n"
      "  - name: tube\n    tube: {length: 60, radius: 6, around: 1000, along: 999}\n"
      "    wall: {thickness: 0.6, young: 1.0, poisson: 0.3}\n"
      "ends:\n  - {vessel: tube, end: start, hold: true}\n"
      "  - {vessel: tube, end: end, move: [0, 0, 1]}\nfidelity: coupled\n");
  if (!addresses_can_be_limited) GTEST_SKIP() << "the address sanitizer reserves terabytes";
  const auto run = solve(scene, "", 60, "ulimit -v 4000000; ");
  EXPECT_EQ(run.exit_code, 3);
  EXPECT_NE(run.err.find("vessel tube: found 1000000 vertices"), std::string::npos) << run.err;
  EXPECT_NE(run.err.find("GB that this process may have"), std::string::npos) << run.err;
  EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
  EXPECT_FALSE(fs::exists(scratch / "out"));
}

// With little memory the BLAS looked for its buffers for ever.
TEST_F(TimeLimit, LittleMemoryEndsInAResultOrOneSentence) {
  if (!addresses_can_be_limited) GTEST_SKIP() << "the address sanitizer reserves terabytes";
  const std::string scene = write(small_glenn("coupled"));
  for (const int kilobytes : {150'000, 250'000, 400'000}) {
    const auto run = solve(scene, "", 60,
                           "ulimit -v " + std::to_string(kilobytes) + "; OPENBLAS_NUM_THREADS=1 ");
    if (run.exit_code == 0) continue;
    EXPECT_EQ(run.exit_code, 3) << kilobytes << ": " << run.err;
    EXPECT_NE(run.err.find("memory"), std::string::npos) << run.err;
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
  }
}

}  // namespace
}  // namespace vasorod::testing
