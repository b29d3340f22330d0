// Fidelity coupled as a user runs it: one minimum of the walls, its result folder.
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <fstream>
#include <nlohmann/json.hpp>

#include "program/run_program.h"
#include "program/small_glenn.h"

namespace vasorod::testing {
namespace {

using nlohmann::json;

json solve(const std::string& scene, int exit_code = 0) {
  const ScratchFolder scratch;
  std::ofstream(scratch / "scene.yaml") << scene;
  const auto run = run_program(vasorod("solve '" + (scratch / "scene.yaml").string() + "' -o '" +
                                       (scratch / "out").string() + "' --json"));
  EXPECT_EQ(run.exit_code, exit_code) << run.err << run.out;
  return json::parse(run.out);
}

std::string tube(const std::string& name, const std::string& wall, const std::string& moved) {
  return "scene: " + name +
         "\nunits: {length: mm, stress: MPa}\nvessels:\n"
         "  - name: tube\n    tube: {length: 100, radius: 10, around: 32, along: 50}\n    wall: " +
         wall + "\nends:\n  - {vessel: tube, end: start, hold: true}\n  - {vessel: tube, end: end, " + moved +
         "}\nfidelity: coupled\n";
}

const std::string isotropic = "{thickness: 1.0, young: 1.0, poisson: 0.3}";

TEST(Coupled, ABendFlattensTheTubeAndBalances) {
  // 10 degrees over 100 mm: a third of the Brazier curvature.
  const json result = solve(tube("bend", isotropic, "rotate_deg: [0, 10, 0], move: [8.7044, 0, -0.5069]"));
  EXPECT_EQ(result.at("status"), "converged");
  EXPECT_EQ(result.at("certificate").at("smallest_curvature_positive"), true);
  EXPECT_LT(result.at("balance")[0].at("residual").get<double>(), 1e-6);
  EXPECT_EQ(result.at("energy").at("rod"), 0) << "the walls carry all of it";
  EXPECT_GT(result.at("energy").at("stretching").get<double>(), 0);
  EXPECT_GT(result.at("energy").at("bending").get<double>(), 0);
  // E I k with I of the ring, softened by a few percent of flattening, which the rigid ends hinder.
  const double rod = M_PI * 1000 * (1 + 0.0025) * M_PI / 18 / 100;
  const double moment = result.at("ends")[1].at("moment")[1].get<double>();
  EXPECT_LT(moment, rod);
  EXPECT_GT(moment, 0.95 * rod);
  EXPECT_GT(result.at("metrics")[0].at("flattening").get<double>(), 0.01);
  // Away from the ends the sections' means are bent as the motion asks.
  EXPECT_NEAR(result.at("metrics")[0].at("largest_curvature").get<double>(), M_PI / 1800, 0.1 * M_PI / 1800);
}

TEST(Coupled, ATwistedTransverselyIsotropicTubeAnswersWithItsOwnShearModulus) {
  const json result = solve(
      tube("twist",
           "{thickness: 1.0, young: 1.0, shear: 0.1, transverse: {young: 0.7, poisson: 0.3, coupling: 0.1}}",
           "rotate_deg: [0, 0, 1]"));
  EXPECT_EQ(result.at("status"), "converged");
  const double exact = 0.1 * 2 * M_PI * 1000 * (1 + 0.0025) * (M_PI / 180) / 100;
  EXPECT_NEAR(result.at("ends")[1].at("moment")[2].get<double>(), exact, 0.01 * exact);
}

// Bent to 0.9 of the Brazier curvature this tube between rigid ends kinks on the way, near 0.75 (design.md,
// section 1).
TEST(Coupled, PastItsLimitATubeIsFollowedToItsKinkAndSaysSo) {
  const json result =
      solve(tube("kink", isotropic, "rotate_deg: [0, 25.4604, 0], move: [21.8567, 0, -3.2574]"), 1);
  EXPECT_EQ(result.at("status"), "buckled");
  EXPECT_EQ(result.at("certificate").at("smallest_curvature_positive"), true);
  EXPECT_FALSE(result.at("validity").at("in_range").get<bool>());
  EXPECT_GT(result.at("metrics")[0].at("flattening").get<double>(), 0.3);
}

// Two tubes, one cut and joined to the other's side: everything yields, the seam closes, both vessels
// balance.
TEST(Coupled, ASmallGlennIsOneMinimumOfBothVesselsAndTheirSeam) {
  const json result = solve(small_glenn("coupled"));
  EXPECT_EQ(result.at("status"), "converged");
  EXPECT_EQ(result.at("certificate").at("smallest_curvature_positive"), true);
  EXPECT_LT(result.at("glenn").at("join").at("largest_gap").get<double>(), 0.01 * 3.3);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double largest = 0;
  for (const auto& vessel : result.at("balance")) {
    EXPECT_LT(vessel.at("residual").get<double>(), 1e-6) << vessel;
    for (int k = 0; k < 3; ++k) sum[k] += vessel.at("join")[static_cast<size_t>(k)].get<double>();
    largest = std::max(largest, std::abs(vessel.at("join")[2].get<double>()));
  }
  EXPECT_GT(largest, 0);
  EXPECT_LT(sum.norm(), 1e-9 * largest) << "the seam pulls on both alike";
}

}  // namespace
}  // namespace vasorod::testing
