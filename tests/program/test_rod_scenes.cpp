// Every bare-rod scene of benchmarks/cases/rod through the built program, compared with the digits
// in its first lines.
#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>

#include "program/run_program.h"

namespace vasorod::testing {
namespace {

const std::filesystem::path cases =
    std::filesystem::path(VASOROD_SOURCE_DIR) / "benchmarks/cases/rod";

nlohmann::json solved(const std::string& name, int exit_code) {
  const ScratchFolder scratch;
  const auto run =
      run_program(vasorod("solve '" + (cases / (name + ".yaml")).string() +
                          "' --fidelity rod -o '" + (scratch / "out").string() + "' --json"));
  EXPECT_EQ(run.exit_code, exit_code) << name << ": " << run.err;
  return nlohmann::json::parse(run.out);
}

struct Digits {
  std::string name, status;
  std::optional<double> energy;
  double energy_error;      // relative
  std::string vessel, end;  // of which `center` is given
  std::optional<std::array<double, 3>> center;
  double center_error;
  int iterations;  // at most; an extrapolated scene solves twice
};

constexpr double pi = 3.14159265358979323846;
constexpr std::nullopt_t none = std::nullopt;
// An extrapolated scene reaches the digits; the others are second order in the element size.
const std::vector<Digits> table = {
    {"b1-elastica",
     "converged",
     none,
     0,
     "beam",
     "end",
     {{1 - 0.387628360724, 0.713791523612, 0}},
     1e-6,
     16},
    {"b4-timoshenko", "converged", none, 0, "beam", "end", {{2.99926793, 0.06774842, 0}}, 3e-5, 8},
    {"b5-rollup", "equilibrium_only", 2 * pi* pi, 1e-11, "beam", "end", {{0, 0, 0}}, 1e-10, 8},
    {"b5-rollup-plane", "converged", 2 * pi* pi, 1e-11, "beam", "end", {{0, 0, 0}}, 1e-10, 8},
    {"b6-helix",
     "equilibrium_only",
     0.0958801882209,
     1e-10,
     "wire",
     "end",
     {{0, -10, 50}},
     1e-8,
     8},
    {"b7-bend45",
     "converged",
     10695.37439,
     2e-4,
     "bend",
     "end",
     {{15.684800534, 47.150438574, 53.474858792}},
     1.04e-2,
     8},
    {"b7-bend45-extrapolated",
     "converged",
     10695.37439,
     1e-7,
     "bend",
     "end",
     {{15.684800534, 47.150438574, 53.474858792}},
     1e-6,
     16},
    {"b7-bend45-3000",
     "converged",
     30082.92566,
     1e-7,
     "bend",
     "end",
     {{4.232875917, 23.024308225, 68.539089493}},
     1e-6,
     20},
    {"b7-bend45-shear",
     "converged",
     8113.89455,
     1e-7,
     "bend",
     "end",
     {{18.508064876, 52.238261847, 48.503491532}},
     1e-6,
     16},
    {"b7-bend45-kirchhoff",
     "converged",
     10693.69900,
     1e-7,
     "bend",
     "end",
     {{15.685078162, 47.151294315, 53.468598442}},
     1e-6,
     16},
    {"b7-bend45-slender",
     "converged",
     1.2832439000 / 100 * (1e7 * 1e-8 / 12),
     1e-7,
     "bend",
     "end",
     {{15.685078134, 47.151294315, 53.468599068}},
     1e-6,
     16},
    {"b11-column", "converged", none, 0, "column", "end", none, 0, 60},
    {"b11-haringx", "converged", none, 0, "column", "end", none, 0, 8},
    {"b11-haringx-above", "converged", none, 0, "column", "end", none, 0, 60},
    {"b11-twist", "converged", 8.9 * 8.9 / 1.6, 1e-10, "rod", "end", {{1, 0, 0}}, 1e-9, 8},
    {"b11-ring", "converged", none, 0, "ring", "end", {{0, 0, 0}}, 1e-12, 40},
    {"b11-greenhill", "equilibrium_only", 18, 1e-10, "shaft", "end", {{1, 0, 0}}, 1e-10, 8},
    {"b12-pose-60", "converged", 4.975051418, 1e-3, "rod", "end", {{0.8, 0.1, 0.05}}, 1e-12, 20},
    {"b12-pose-60-slender",
     "converged",
     4.975112310,
     2e-7,
     "rod",
     "end",
     {{0.8, 0.1, 0.05}},
     1e-12,
     40},
    {"b12-pose-120", "converged", 9.368806732, 1e-3, "rod", "end", {{0.6, 0.2, 0.1}}, 1e-12, 25},
    {"b12-pose-120-thick",
     "converged",
     9.361704850,
     2e-7,
     "rod",
     "end",
     {{0.6, 0.2, 0.1}},
     1e-12,
     50},
    {"b13-tree",
     "converged",
     3.055132910623,
     2e-4,
     "left",
     "end",
     {{102.8549255711, -4.5620702458, 29.0381134982}},
     3e-2,
     10},
    {"b14-objectivity", "converged", 4.975112310, 2e-7, "rod", "end", none, 0, 40},
    {"b14-moduli", "converged", 4.975112310e-6, 2e-7, "rod", "end", {{0.8, 0.1, 0.05}}, 1e-12, 40},
    {"catenary", "converged", none, 0, "chain", "at(0.5)", {{0.4, -0.265437509140, 0}}, 1e-4, 2000},
    {"inside", "converged", none, 0, "beam", "at(0.4)", none, 0, 10},
    {"patch-stretch", "converged", 6.3, 1e-10, "bar", "end", {{2.6, 0, 0}}, 1e-10, 8},
    {"patch-shear", "converged", 44.175, 1e-10, "bar", "end", {{3.5, 0.8, 0}}, 1e-10, 8},
    {"patch-twist", "equilibrium_only", 1.764, 1e-10, "bar", "end", {{2, 0, 0}}, 1e-10, 8},
    {"patch-bend",
     "equilibrium_only",
     1.872,
     1e-10,
     "bar",
     "end",
     {{0.562885983792626, 0, -1.44782809628437}},
     1e-10,
     8},
    {"patch-spring",
     "equilibrium_only",
     0.998607460214367,
     1e-10,
     "bar",
     "end",
     {{1.02622702645379, 1.77320208517866, 1.01612132157609}},
     1e-10,
     100},
    {"lost-turns", "buckled", 1.6 * pi* pi, 1e-10, "rod", "end", {{1, 0, 0}}, 1e-10, 50},
    {"turns", "converged", 200 * pi* pi, 1e-10, "rod", "end", {{1, 0, 0}}, 1e-10, 8},
};

class RodCase : public ::testing::TestWithParam<Digits> {};

TEST_P(RodCase, ReachesItsDigits) {
  const Digits& d = GetParam();
  const auto result = solved(d.name, d.status == "converged" ? 0 : 1);
  EXPECT_EQ(result.at("status"), d.status) << d.name;
  // without an energy, there is no curvature to report
  EXPECT_EQ(result.at("certificate").at("smallest_curvature_positive"),
            d.status == "equilibrium_only" ? nlohmann::json(nullptr) : nlohmann::json(true))
      << d.name;
  EXPECT_LT(result.at("certificate").at("relative_residual").get<double>(), 1e-9) << d.name;
  EXPECT_LE(result.at("iterations").at("rod").get<int>(), d.iterations) << d.name;
  if (d.energy) {
    EXPECT_NEAR(result.at("energy").at("rod").get<double>(), *d.energy, d.energy_error * *d.energy)
        << d.name;
  }
  for (const auto& end : result.at("ends")) {
    if (!d.center || end.at("vessel") != d.vessel || end.at("end") != d.end) continue;
    for (std::size_t i = 0; i < 3; ++i)
      EXPECT_NEAR(end.at("center")[i].get<double>(), (*d.center)[i], d.center_error)
          << d.name << ' ' << i;
  }
  for (const auto& balance : result.at("balance"))
    EXPECT_LT(balance.at("residual").get<double>(), 1e-6) << d.name;
}

INSTANTIATE_TEST_SUITE_P(Scenes, RodCase, ::testing::ValuesIn(table), [](const auto& scene) {
  std::string name = scene.param.name;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

TEST(RodCases, EverySceneIsInTheTable) {
  std::set<std::string> known;
  for (const Digits& d : table) known.insert(d.name);
  int files = 0;
  for (const auto& file : std::filesystem::directory_iterator(cases))
    if (file.path().extension() == ".yaml") {
      ++files;
      EXPECT_EQ(known.count(file.path().stem().string()), 1U) << file.path();
    }
  EXPECT_EQ(files, static_cast<int>(table.size()));
}

TEST(RodCases, ReactionsAtEverySupportHoldTheLoads) {
  const auto inside = solved("inside", 0);
  double sum = 0;
  int supports = 0;
  for (const auto& end : inside.at("ends")) {
    sum += end.at("force")[1].get<double>();
    supports += std::abs(end.at("force")[1].get<double>()) > 1e-6;
  }
  EXPECT_EQ(supports, 3);  // start, the pin inside, end
  EXPECT_NEAR(sum, -0.1, 1e-10);
  const auto chain = solved("catenary", 0);
  for (const auto& end : chain.at("ends")) {
    if (end.at("end") != "start") continue;
    EXPECT_NEAR(end.at("force")[0].get<double>(), -0.338201879085,
                2e-4);  // the catenary's horizontal tension
    EXPECT_NEAR(end.at("force")[1].get<double>(), 0.5 - 0.5 / 40, 1e-9);
  }
}

TEST(RodCases, AStraightSaddleIsLeft) {
  for (const char* name : {"b11-column", "b11-haringx-above"}) {
    const auto result = solved(name, 0);
    const auto center = result.at("ends")[1].at("center");
    EXPECT_GT(std::hypot(center[1].get<double>(), center[2].get<double>()), 0.1) << name;
    EXPECT_NE(result.at("certificate").at("notes")[0].get<std::string>().find("one of a family"),
              std::string::npos);
  }
}

struct Wrong {
  std::string rods, ends, sentence;
};

TEST(RodCases, WhatCannotBeIsOneSentence) {
  const std::string stiffness = "stiffness: {axial: 1, shear: [1, 1], bending: [1, 1], torsion: 1}",
                    good =
                        "  - name: a\n    rod: {position: [0, 0, 0], tangent: [1, 0, 0], normal: "
                        "[0, 1, 0], pieces: "
                        "[{length: 1, elements: 4}], " +
                        stiffness + "}\n",
                    held = "  - {vessel: a, end: start, hold: true}\n",
                    pulled = "  - {vessel: a, end: end, force: [0, 1, 0]}\n";
  const auto with = [&](std::string text, const std::string& from, const std::string& to) {
    const auto at = text.find(from);
    if (at == std::string::npos) throw std::logic_error("no " + from);
    return text.replace(at, from.size(), to);
  };
  const std::string child =
      with(with(good, "name: a", "name: b"), "rod: {position", "rod: {parent: a, position");
  for (const Wrong& wrong :
       {Wrong{good, pulled,
              "the loads drive a rigid motion that no support stops: translation along (0, 1, 0)"},
        {good, "  - {vessel: a, end: start, fix: [x, y, z, rz]}\n" + pulled,
         "no support stops: rotation about the axis (0, 0, 1) through (0, 0, 0)"},
        {with(good, "length: 1", "length: 0"), held, "length"},
        {with(good, "torsion: 1", "torsion: -1"), held, "torsion"},
        {with(good, "normal: [0, 1, 0]", "normal: [2, 0, 0]"), held, "normal"},
        {with(good, "tangent: [1, 0, 0]", "tangent: [0, 0, 0]"), held, "tangent"},
        {with(good, "rod: {position", "rod: {parent: nobody, position"), held, "nobody"},
        {with(good, "rod: {position", "rod: {parent: b, position") + child, held, "parent"},
        {with(good, stiffness,
              "stiffness: {matrix: [[1, 0, 0, 2, 0, 0], [0, 1, 0, 0, 0, 0], [0, 0, 1, 0, 0, 0], "
              "[2, 0, 0, 1, "
              "0, 0], "
              "[0, 0, 0, 0, 1, 0], [0, 0, 0, 0, 0, 1]]}"),
         held, "positive definite"},
        {good,
         "  - {vessel: a, end: start, hold: true}\n  - {vessel: a, end: end, rotate_deg: [0, 0, "
         "1000]}\n",
         "use more elements"}}) {
    const ScratchFolder scratch;
    std::ofstream(scratch / "scene.yaml")
        << "scene: wrong\nunits: {length: mm, stress: MPa}\nvessels:\n"
        << wrong.rods << "ends:\n"
        << wrong.ends << "fidelity: rod\n";
    const auto run = run_program(vasorod("solve '" + (scratch / "scene.yaml").string() + "' -o '" +
                                         (scratch / "out").string() + "'"));
    EXPECT_EQ(run.exit_code, 2) << wrong.sentence << ": " << run.err;
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
    EXPECT_NE(run.err.find(wrong.sentence), std::string::npos) << run.err;
    EXPECT_FALSE(std::filesystem::exists(scratch / "out"));
  }
}

}  // namespace
}  // namespace vasorod::testing
