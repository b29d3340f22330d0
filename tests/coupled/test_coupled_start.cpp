// Walls that start where coarser ones are said to have gone.
#include <gtest/gtest.h>

#include <vasorod/error.h>

#include "coupled/coupled_contacts.h"
#include "coupled/coupled_stack.h"
#include "numerics/blas.h"

namespace vasorod {
namespace {

using namespace testing;

constexpr double radius = 6;

// Two tubes that cross, the first pressed onto the second; the second is touched only on the way.
CoupledProblem crossed() {
  const HeldTube tube(40, radius, 0.6, 32, 36);
  CoupledProblem problem;
  const Vec3 down(-1.5, 0, 0);
  HeldSection start = tube.start(), end = tube.end();
  start.motion.move = end.motion.move = down;
  add_tube(problem, tube, "one", Vec3::Zero(), {start, end});
  const Mat3 across = Eigen::AngleAxisd(M_PI / 2, Vec3::UnitX()).toRotationMatrix();
  add_tube(problem, tube, "other", Vec3(-2 * radius - 1, 20, 20), {tube.start(), tube.end()},
           across);
  problem.surfaces.contacts = all_contacts(problem.surfaces.bodies);
  carry_by_sections(problem);
  return problem;
}

CoupledStart start_at(const CoupledSolution& solution) {
  CoupledStart start;
  for (const BodySolution& body : solution.surface.bodies) {
    start.bodies.emplace_back();
    if (body.modelled) start.bodies.back().points = body.positions;
    start.pressure.push_back(body.pressure);
  }
  return start;
}

CoupledSolution from(CoupledStart start) {
  CoupledProblem problem = crossed();
  problem.start = std::move(start);
  CoupledSolver solver(std::move(problem));
  return solver.solve();
}

// Alternately in and out, by a share of the radius.
void roughen(double share, CoupledStart& start) {
  for (CarriedBody& body : start.bodies)
    for (Eigen::Index i = 100; i + 100 < body.points.rows(); ++i)
      body.points.row(i) += share * radius *
                            Eigen::RowVector3d(std::sin(7.0 * static_cast<double>(i)),
                                               std::sin(11.0 * static_cast<double>(i)), 0);
}

class CoupledStartTest : public ::testing::Test {
 protected:
  CoupledStartTest() {
    CoupledSolver solver(crossed());
    reference_ = solver.solve();
  }
  double away(const CoupledSolution& solution) const {
    double largest = 0;
    for (size_t b = 0; b < 2; ++b)
      largest = std::max(
          largest, (solution.surface.bodies[b].positions - reference_.surface.bodies[b].positions)
                       .rowwise()
                       .norm()
                       .maxCoeff());
    return largest / radius;
  }

  CoupledSolution reference_;
};

TEST_F(CoupledStartTest, ARoughStartEndsInTheSameMinimumWithFewFactorisations) {
  ASSERT_EQ(reference_.status, Status::converged);
  ASSERT_TRUE(reference_.surface.bodies[1].modelled);
  CoupledStart start = start_at(reference_);
  roughen(0.01, start);
  const CoupledSolution solution = from(start);
  EXPECT_EQ(solution.status, Status::converged) << to_string(solution.status);
  EXPECT_TRUE(solution.smallest_curvature_positive);
  EXPECT_LT(away(solution), 1e-4);
  // Other kernels of OpenBLAS than those for AVX2 round otherwise, which takes one more.
  const std::string blas = blas_name();
  const bool avx2 =
      blas.find("Haswell") != std::string::npos || blas.find("Zen") != std::string::npos;
  const int factorisations = solution.surface.work.counts.factorisations;
  EXPECT_LE(factorisations, avx2 ? 4 : 5) << blas;
  // With the true Hessian from the beginning it takes more than twice as many.
  start.roughness = Roughness::near;
  EXPECT_LT(2 * factorisations, from(start).surface.work.counts.factorisations);
}

// Bent to the side by half a radius.
TEST_F(CoupledStartTest, ASmoothStartEndsInTheSameMinimumWithFewerFactorisationsThanANearOne) {
  CoupledStart start = start_at(reference_);
  Points& points = start.bodies[0].points;
  for (Eigen::Index i = 0; i < points.rows(); ++i)
    points(i, 1) += 0.5 * radius * std::pow(std::sin(M_PI * points(i, 2) / 40), 2);
  start.roughness = Roughness::smooth;
  const CoupledSolution solution = from(start);
  EXPECT_EQ(solution.status, Status::converged) << to_string(solution.status);
  EXPECT_TRUE(solution.smallest_curvature_positive);
  EXPECT_LT(away(solution), 1e-4);
  start.roughness = Roughness::near;
  EXPECT_LT(solution.surface.work.counts.factorisations,
            from(start).surface.work.counts.factorisations);
}

TEST_F(CoupledStartTest, AStartThatBuckledOnItsWaySaysSo) {
  CoupledStart start = start_at(reference_);
  start.buckled = true;
  const CoupledSolution solution = from(start);
  EXPECT_EQ(solution.status, Status::buckled) << to_string(solution.status);
  EXPECT_LT(away(solution), 1e-4);
}

// Without the second tube in it, and without its pressure.
TEST_F(CoupledStartTest, WhatWasNotExpectedToBeTouchedIsFound) {
  CoupledStart start = start_at(reference_);
  start.bodies[1] = {};
  for (Eigen::VectorXd& pressure : start.pressure) pressure.resize(0);
  const CoupledSolution solution = from(start);
  EXPECT_EQ(solution.status, Status::converged) << to_string(solution.status);
  EXPECT_LT(away(solution), 1e-4);
}

// It takes more factorisations than a crumpled one may, most of them of positive Hessians.
TEST_F(CoupledStartTest, ARougherOneGoesOnWhileItsHessiansArePositive) {
  CoupledStart start = start_at(reference_);
  roughen(0.12, start);
  const CoupledSolution solution = from(start);
  EXPECT_EQ(solution.status, Status::converged) << to_string(solution.status);
  EXPECT_LT(away(solution), 1e-4);
}

TEST_F(CoupledStartTest, ACrumpledOneEndsSoonWithASentence) {
  CoupledStart start = start_at(reference_);
  roughen(0.6, start);
  const CoupledSolution solution = from(start);
  EXPECT_EQ(solution.status, Status::iteration_limit) << to_string(solution.status);
  ASSERT_FALSE(solution.notes.empty());
  EXPECT_EQ(solution.notes.front(), "no minimum was found near the given start");
  EXPECT_LE(solution.surface.work.counts.factorisations, 16);
}

TEST_F(CoupledStartTest, WhatIsPressedOnAtTheCarriedPlacesIsExpectedToBeTouched) {
  CoupledStack stack(crossed(), {});
  stack.build();
  EXPECT_LT(stack.first_wall[1], 0);
  stack.prepare([] { return false; });
  EXPECT_GE(stack.first_wall[1], 0) << "built again with it";
  EXPECT_TRUE(stack.scaled.bodies[1].modelled);
  stack.begin_solve();
  EXPECT_FALSE(stack.scaled.bodies[1].modelled) << "no start says that it is touched";
  EXPECT_FALSE(stack.system);
}

// The start may say that the second tube was touched, or not; and the work may be given up.
TEST_F(CoupledStartTest, WhatIsBuiltBeforeTheStartIsKnownChangesNoNumber) {
  CoupledStart right = start_at(reference_), wrong = right;
  roughen(0.01, right);
  wrong.bodies[1] = {};
  for (Eigen::VectorXd& pressure : wrong.pressure) pressure.resize(0);
  for (const CoupledStart& start : {right, wrong}) {
    std::vector<CoupledSolution> found;
    for (const int questions : {0, 1, 2, 100}) {  // until it is given up
      CoupledSolver solver(crossed());
      int asked = 0;
      solver.prepare([&] { return ++asked > questions; });
      solver.set_start(start);
      found.push_back(solver.solve());
    }
    EXPECT_EQ(found[0].status, Status::converged) << to_string(found[0].status);
    EXPECT_LT(away(found[0]), 1e-4);
    for (size_t k = 1; k < found.size(); ++k) {
      for (size_t body = 0; body < 2; ++body)
        EXPECT_EQ(found[k].surface.bodies[body].positions, found[0].surface.bodies[body].positions);
      EXPECT_EQ(found[k].surface.work.counts, found[0].surface.work.counts);
    }
  }
}

TEST_F(CoupledStartTest, WhatIsBuiltBeforeASolveWithoutAStartIsNotInItsResult) {
  CoupledSolver solver(crossed());
  solver.prepare([] { return false; });
  const CoupledSolution solution = solver.solve();
  EXPECT_EQ(solution.status, Status::converged) << to_string(solution.status);
  EXPECT_LT(away(solution), 1e-9);
}

TEST_F(CoupledStartTest, AStartOfAWallThatNothingHoldsIsRefused) {
  CoupledProblem problem = crossed();
  problem.vessels[1]->sections.clear();
  CoupledSolver solver(std::move(problem));
  EXPECT_THROW(solver.set_start(start_at(reference_)), InputError);
}

}  // namespace
}  // namespace vasorod
