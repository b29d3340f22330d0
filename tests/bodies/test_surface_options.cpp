#include "bad_options.h"
#include "bodies/surface_options.h"

namespace vasorod {
namespace {

using namespace testing;

TEST(SurfaceOptions, AFieldOutOfItsRangeIsNamed) {
  using O = SurfaceOptions;
  expect_named<O>("time_limit", &O::time_limit, {-1.0, no_number});
  expect_positive<O>("tolerance", &O::tolerance);
  expect_positive<O>("balance_tolerance", &O::balance_tolerance);
  expect_positive<O>("seam_tolerance", &O::seam_tolerance);
  expect_positive<O>("contact_tolerance", &O::contact_tolerance);
  expect_positive<O>("slip_tolerance", &O::slip_tolerance);
  expect_positive<O>("pressure_tolerance", &O::pressure_tolerance);
  expect_positive<O>("seam_stiffness", &O::seam_stiffness);
  expect_positive<O>("contact_stiffness", &O::contact_stiffness);
  expect_named<O>("max_outer", &O::max_outer, {0, -1});
  expect_named<O>("max_iterations", &O::max_iterations, {0, -1});
  expect_named<O>("max_factorisations", &O::max_factorisations, {-1});
}

TEST(SurfaceOptions, TheEndsOfTheRangesAreValid) {
  using O = SurfaceOptions;
  expect_valid<O>(&O::time_limit, {0.0, infinite});
  expect_valid<O>(&O::tolerance, {1e-300});
  expect_valid<O>(&O::max_outer, {1});
  expect_valid<O>(&O::max_iterations, {1});
  expect_valid<O>(&O::max_factorisations, {0});
}

}  // namespace
}  // namespace vasorod
