#include <vasorod/error.h>

#include "bad_options.h"
#include "rod/rods.h"

namespace vasorod {
namespace {

using namespace testing;

TEST(RodOptions, AFieldOutOfItsRangeIsNamed) {
  using O = RodOptions;
  expect_named<O>("time_limit", &O::time_limit, {-1.0, no_number});
  expect_positive<O>("tolerance", &O::tolerance);
  expect_named<O>("max_iterations", &O::max_iterations, {0, -1});
  expect_named<O>("path_steps", &O::path_steps, {0, -1});
}

TEST(RodOptions, TheEndsOfTheRangesAreValid) {
  using O = RodOptions;
  expect_valid<O>(&O::time_limit, {0.0, infinite});
  expect_valid<O>(&O::max_iterations, {1});
  expect_valid<O>(&O::path_steps, {1});
}

TEST(RodOptions, TheSolverRefusesThemWithTheSentence) {
  const RodTree rod = chain({}, 10, Vec3::Zero(), 4, isotropic(1, 1, 1, 1));
  RodOptions options;
  options.path_steps = 0;
  try {
    solve_rod(rod, {{clamp(0)}, {}}, options);
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "options of the rod: path_steps: expected at least 1");
  }
}

TEST(RodSummary, TheBriefReportSaysStatusCountsAndResidual) {
  RodSummary summary;
  summary.status = Status::equilibrium_only;
  summary.residual = 3e-12;
  summary.iterations = 14;
  EXPECT_EQ(summary.brief_report(), "equilibrium_only: residual 3e-12 after 14 linear solves");
  summary.message = "a dead moment has no energy";
  EXPECT_EQ(summary.brief_report(),
            "equilibrium_only: residual 3e-12 after 14 linear solves; a dead moment has no energy");
}

}  // namespace
}  // namespace vasorod
