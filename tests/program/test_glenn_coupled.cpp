// The bundled anatomy at fidelity coupled. Each test takes half a minute and is not among the
// default tests (label long).
#include <cmath>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "program/glenn_scene.h"
#include "program/same_with_threads.h"

namespace vasorod::testing {
namespace {

void expect_one_minimum(const nlohmann::json& result) {
  EXPECT_EQ(result.at("status"), "converged") << result.at("certificate").dump();
  EXPECT_EQ(result.at("certificate").at("smallest_curvature_positive"), true);
  const auto& glenn = result.at("glenn");
  const double mouth_radius = glenn.at("cut").at("perimeter").get<double>() / (2 * M_PI);
  EXPECT_LT(glenn.at("join").at("largest_gap").get<double>(), 0.01 * mouth_radius);
  for (const auto& vessel : result.at("balance"))
    EXPECT_LT(vessel.at("residual").get<double>(), 1e-6) << vessel;
  double largest_pressure = 0;
  for (const auto& pair : result.at("contact"))
    largest_pressure = std::max(largest_pressure, pair.at("largest_pressure").get<double>());
  EXPECT_GT(largest_pressure, 0) << "the vein leans on the aorta";
}

TEST(GlennCoupled, InfantConvergesWithAClosedSeamAContactAndABalance) {
  expect_one_minimum(solve_case("infant.yaml", "--fidelity coupled"));
}

TEST(GlennCoupled, AShorterVeinToo) {
  expect_one_minimum(solve_case("infant_short.yaml", "--fidelity coupled"));
}

// At the slit's tip, the vein's wall folds more sharply than its mesh can resolve; the result
// states this.
TEST(GlennCoupled, ALongerVeinToo) {
  const auto result = solve_case("infant_long.yaml", "--fidelity coupled");
  expect_one_minimum(result);
  EXPECT_NE(result.at("certificate").at("notes").dump().find("degrees over one edge"),
            std::string::npos)
      << result.at("certificate").dump();
}

// Its factor is large enough to be shared between threads.
TEST(GlennCoupled, ThreadsChangeNoNumber) {
  expect_threads_change_no_number(std::string("'") + VASOROD_SOURCE_DIR +
                                  "/benchmarks/cases/glenn/infant.yaml' --fidelity coupled");
}

}  // namespace
}  // namespace vasorod::testing
