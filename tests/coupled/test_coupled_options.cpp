#include <vasorod/error.h>

#include "bad_options.h"
#include "coupled/coupled_problem.h"

namespace vasorod {
namespace {

using namespace testing;
using Times = std::vector<double>;

TEST(CoupledOptions, AFieldOutOfItsRangeIsNamed) {
  using O = CoupledOptions;
  expect_positive<O>("tie_tolerance", &O::tie_tolerance);
  expect_positive<O>("moment_tolerance", &O::moment_tolerance);
  expect_positive<O>("tie_stiffness", &O::tie_stiffness);
  expect_positive<O>("contact_stiffness", &O::contact_stiffness);
  expect_named<O>("max_factorisations", &O::max_factorisations, {-1});
  expect_named<O>("hold_after", &O::hold_after, {-1});
  expect_named<O>("most_per_stage", &O::most_per_stage, {-1});
}

TEST(CoupledOptions, TimesRiseToOne) {
  using O = CoupledOptions;
  expect_named<O, O, Times>("times", &O::times,
                            {{},
                             {0.5},
                             {0, 1},
                             {-0.5, 1},
                             {0.5, 0.25, 1},
                             {0.5, 0.5, 1},  // a step of no length cannot be extrapolated
                             {0.5, 1, 1},
                             {0.5, 2, 1},
                             {0.5, no_number, 1},
                             {no_number, 1}});
  expect_valid<O, O, Times>(&O::times, {{1}, {0.5, 1}, {1e-3, 0.5, 0.999, 1}});
}

TEST(CoupledOptions, TheSolverRefusesThemWithTheSentence) {
  CoupledOptions options;
  options.tolerance = 0;
  try {
    CoupledSolver solver({}, options);
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "options of coupled: tolerance: expected a number above 0");
  }
}

TEST(CoupledSolution, TheBriefReportHasTheWholesStatus) {
  CoupledSolution solution;
  solution.status = Status::not_unique;
  solution.surface.status = Status::converged;
  solution.surface.residual = 1e-10;
  solution.surface.iterations = 9;
  solution.surface.outer_iterations = 2;
  solution.surface.work.counts.factorisations = 5;
  EXPECT_EQ(solution.brief_report(),
            "not_unique: residual 1e-10 after 9 iterations, 2 multiplier updates, 5 "
            "factorisations");
}

}  // namespace
}  // namespace vasorod
