#include <vasorod/error.h>

#include "bad_options.h"
#include "paper/paper_solver.h"

namespace vasorod {
namespace {

using namespace testing;

TEST(PaperOptions, AFieldOutOfItsRangeIsNamed) {
  using O = PaperOptions;
  expect_named<O>("patience", &O::patience, {0, -3});
  expect_named<O>("hold_after", &O::hold_after, {0, -1});
  expect_valid<O>(&O::patience, {1});
  expect_positive<O>("tolerance", &O::tolerance);
  expect_named<O>("max_outer", &O::max_outer, {0});
  expect_named<O>("time_limit", &O::time_limit, {-1.0, no_number});
}

TEST(PaperOptions, TheSolverRefusesThemWithTheSentence) {
  PaperOptions options;
  options.seam_stiffness = -1;
  try {
    solve_paper({}, options);
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "options of paper: seam_stiffness: expected a number above 0");
  }
}

}  // namespace
}  // namespace vasorod
