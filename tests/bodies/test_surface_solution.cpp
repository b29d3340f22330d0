#include <gtest/gtest.h>

#include "bodies/surface_solution.h"

namespace vasorod {
namespace {

TEST(SurfaceSolution, TheBriefReportSaysStatusCountsAndResidual) {
  SurfaceSolution solution;
  solution.status = Status::buckled;
  solution.residual = 2.5e-9;
  solution.iterations = 321;
  solution.outer_iterations = 7;
  solution.work.counts.factorisations = 12;
  EXPECT_EQ(solution.brief_report(),
            "buckled: residual 2.5e-09 after 321 iterations, 7 multiplier updates, 12 "
            "factorisations");
}

TEST(SurfaceSolution, AndTheSeamWhereThereIsOne) {
  SurfaceSolution solution;
  solution.status = Status::converged;
  solution.largest_seam_gap = 0.02;
  EXPECT_EQ(solution.brief_report().find("seam"), std::string::npos) << solution.brief_report();
  solution.seam_radius = 8;
  EXPECT_NE(solution.brief_report().find(", largest seam gap 0.0025 of the mouth's radius"),
            std::string::npos)
      << solution.brief_report();
}

}  // namespace
}  // namespace vasorod
