// `counts` in result.json: how much the solver did, whatever the machine and the units.
#include <fstream>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "program/small_glenn.h"
#include "program/solved_scene.h"

namespace vasorod::testing {
namespace {

using Json = nlohmann::json;

// A tube between rigid ends, one of them moved sideways; `scale`: the length unit in mm.
std::string bent_tube(const std::string& fidelity, const std::string& unit, double scale) {
  const auto mm = [&](double value) { return Json(value / scale).dump(); };
  return "scene: bent\nunits: {length: " + unit + ", stress: MPa}\nvessels:\n" +
         "  - name: tube\n    tube: {length: " + mm(60) + ", radius: " + mm(6) +
         ", around: 20, along: 30}\n    wall: {thickness: " + mm(0.6) +
         ", young: 1.0, poisson: 0.3}\nends:\n  - {vessel: tube, end: start, hold: true}\n" +
         "  - {vessel: tube, end: end, move: [" + mm(4) + ", 0, 0]}\nfidelity: " + fidelity + "\n";
}

// In other units the last bits differ: a line search may then end a few evaluations sooner. `paper`
// ends its iteration far above rounding, and may end an outer iteration sooner or later.
void expect_like(const Json& counts, Json first, const std::string& fidelity) {
  Json same = counts;
  const bool paper = fidelity == "paper";
  for (const char* name : {"gradients", "solves"}) {
    const double expected = first.at(name).get<double>();
    EXPECT_NEAR(counts.at(name).get<double>(), expected, (paper ? 0.6 : 0.05) * expected)
        << fidelity << ' ' << name;
    same.erase(name);
    first.erase(name);
  }
  if (paper) {
    same.erase("outer");
    first.erase("outer");
  }
  EXPECT_EQ(same, first) << fidelity;
}

TEST(Counts, AreThoseOfTheSecondRunAndOfTheSameSceneInMetres) {
  for (const std::string fidelity : {"rod", "skin", "paper", "section", "coupled"}) {
    const Json first = solved_scene(bent_tube(fidelity, "mm", 1)).at("counts");
    EXPECT_EQ(solved_scene(bent_tube(fidelity, "mm", 1)).at("counts"), first) << fidelity;
    expect_like(solved_scene(bent_tube(fidelity, "m", 1000)).at("counts"), first, fidelity);
    const bool surfaces = fidelity != "rod" && fidelity != "skin";
    for (const char* name : {"gradients", "hessians", "outer", "factor_nonzeros"})
      EXPECT_EQ(first.at(name) > 0, surfaces) << fidelity << ' ' << name;
    for (const char* name : {"factorisations", "solves"})
      EXPECT_EQ(first.at(name) > 0, fidelity != "skin") << fidelity << ' ' << name;
  }
}

// The paper's quadratic energies with the seam's pairs as one vertex each: one linear solve.
TEST(Counts, OfASewnSkinAreThoseOfOneLinearProblem) {
  const Json result = solved_scene(small_glenn("skin"));
  const Json& counts = result.at("counts");
  EXPECT_EQ(counts.at("hessians"), 1);
  EXPECT_EQ(counts.at("factorisations"), 1);
  EXPECT_EQ(counts.at("solves"), 1);
  EXPECT_EQ(counts.at("gradients"), 0);
  EXPECT_EQ(counts.at("outer"), 0);
  // A factor is at least as dense as a diagonal.
  EXPECT_GT(counts.at("factor_nonzeros").get<double>(),
            0.5 * result.at("model").at("vertices").get<double>());
}

TEST(Counts, AFitSolvesNothing) {
  const ScratchFolder scratch;
  std::ofstream(scratch / "scene.yaml") << bent_tube("skin", "mm", 1);
  const auto folder = (scratch / "out").string();
  ASSERT_EQ(
      run_program(vasorod("solve '" + (scratch / "scene.yaml").string() + "' -o '" + folder + "'"))
          .exit_code,
      0);
  const auto run =
      run_program(vasorod("fit '" + folder + "/tube.vtp' -o '" + folder + "fit' --json"));
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_FALSE(Json::parse(run.out).contains("counts"));
}

#ifdef __x86_64__
std::string blas_of_a_solve(const std::string& environment) {
  const ScratchFolder scratch;
  std::ofstream(scratch / "scene.yaml") << bent_tube("rod", "mm", 1);
  const ProgramRun run = run_program("env " + environment + " " +
                                     vasorod("solve '" + (scratch / "scene.yaml").string()) +
                                     "' --no-report -o '" + (scratch / "result").string() + "'");
  EXPECT_EQ(run.exit_code, 0) << run.err;
  return Json::parse(contents_of(scratch / "result" / "result.json"))
      .at("environment")
      .at("blas")
      .get<std::string>();
}

// OpenBLAS takes those for SSE3 (Prescott) on processors that it does not know; on others the first
// line holds without the program's own choice.
TEST(Kernels, AreThoseOfTheProcessorOrThoseAskedFor) {
  if (!__builtin_cpu_supports("avx2") || !__builtin_cpu_supports("fma"))
    GTEST_SKIP() << "this processor has no AVX2";
  EXPECT_EQ(blas_of_a_solve("-u OPENBLAS_CORETYPE").find(" Prescott "), std::string::npos);
  for (const std::string asked : {"Prescott", "Nehalem", "Haswell"})
    EXPECT_NE(blas_of_a_solve("OPENBLAS_CORETYPE=" + asked).find(" " + asked + " "),
              std::string::npos)
        << asked;
}
#endif

}  // namespace
}  // namespace vasorod::testing
