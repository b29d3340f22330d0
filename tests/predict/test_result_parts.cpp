#include <gtest/gtest.h>

#include <vasorod/version.h>

#include "numerics/blas.h"
#include "predict/result_parts.h"

namespace vasorod {
namespace {

RodSummary summary_of(Status status, double residual, double energy, int iterations) {
  RodSummary summary;
  summary.status = status;
  summary.residual = residual;
  summary.energy = energy;
  summary.iterations = iterations;
  return summary;
}

TEST(ResultParts, EveryResultBeginsWithNamesUnitsProgramAndEnvironment) {
  Units units;
  units.length = "cm";
  units.stress = "kPa";
  const Result result = begin_result("glenn", "paper", units, 3);
  EXPECT_EQ(result.scene, "glenn");
  EXPECT_EQ(result.fidelity, "paper");
  EXPECT_EQ(result.program, "vasorod " + version());
  EXPECT_EQ(result.length_unit, "cm");
  EXPECT_EQ(result.stress_unit, "kPa");
  EXPECT_EQ(result.environment.blas, blas_name());
  EXPECT_EQ(result.environment.threads, 3);
  EXPECT_EQ(result.iterations, (std::map<std::string, int>{{"rod", 0}, {"surface", 0}}));
  EXPECT_EQ(result.status, Status::converged);
  EXPECT_TRUE(result.vessels.empty());
  EXPECT_EQ(result.energy.total(), 0);
  EXPECT_FALSE(result.certificate.smallest_curvature_positive);
}

TEST(ResultParts, RodsAddUpAndTheWorstOneCounts) {
  Result result = begin_result("s", "rod", {}, 1);
  add_rod("a", summary_of(Status::converged, 1e-12, 2, 5), true, result);
  EXPECT_EQ(result.certificate.smallest_curvature_positive, true);
  EXPECT_TRUE(result.certificate.notes.empty());
  RodSummary second = summary_of(Status::unstable, 3e-10, 0.5, 7);
  second.negative_directions = 1;
  second.message = "a direction of negative curvature is left";
  add_rod("b", second, true, result);
  add_rod("c", summary_of(Status::converged, 1e-11, 0.25, 2), true, result);
  EXPECT_EQ(result.status, Status::unstable);
  EXPECT_EQ(result.certificate.relative_residual, 3e-10);
  EXPECT_EQ(result.certificate.smallest_curvature_positive, false) << "one saddle is enough";
  EXPECT_EQ(result.certificate.notes,
            std::vector<std::string>{"rod of b: a direction of negative curvature is left"});
  EXPECT_EQ(result.energy.rod, 2.75);
  EXPECT_EQ(result.iterations.at("rod"), 14);
  EXPECT_EQ(result.iterations.at("surface"), 0);
}

TEST(ResultParts, ARodWithoutAnEquilibriumSaysWhy) {
  for (const int iterations : {0, 40}) {
    Result result = begin_result("s", "paper", {}, 1);
    add_rod("svc", summary_of(Status::iteration_limit, 0.125, 0, iterations), false, result);
    ASSERT_EQ(result.certificate.notes.size(), 1U);
    EXPECT_EQ(result.certificate.notes[0],
              "rod of svc: no equilibrium was found: residual 0.125 after " +
                  std::to_string(iterations) + " linear solves");
  }
  Result result = begin_result("s", "paper", {}, 1);
  RodSummary stuck = summary_of(Status::iteration_limit, 0.125, 0, 7);
  stuck.message = "the path could be followed only to 40 % of the load";
  add_rod("svc", stuck, false, result);
  EXPECT_NE(result.certificate.notes.at(0).find("; the path could be followed"), std::string::npos);
}

TEST(ResultParts, NoCertificateIsGivenUnaskedOrWithoutAnEquilibrium) {
  Result unasked = begin_result("s", "paper", {}, 1);
  add_rod("a", summary_of(Status::converged, 0, 0, 1), false, unasked);
  EXPECT_FALSE(unasked.certificate.smallest_curvature_positive);
  for (const Status status : {Status::iteration_limit, Status::interrupted,
                              Status::equilibrium_only, Status::not_unique}) {
    Result result = begin_result("s", "rod", {}, 1);
    add_rod("a", summary_of(status, 1, 0, 40), true, result);
    EXPECT_FALSE(result.certificate.smallest_curvature_positive) << to_string(status);
    EXPECT_EQ(result.status, status);
  }
}

}  // namespace
}  // namespace vasorod
