#include <gtest/gtest.h>

#include <vasorod/error.h>

#include "coupled/held_tubes.h"
#include "numerics/blas.h"
#include "wall/shear_band.h"

namespace vasorod {
namespace {

using namespace testing;

HeldSection free_of_all(HeldSection section) {
  section.fixed.fill(false);
  return section;
}

Vec6 strain(double stretch, double curvature, double twist) {
  Vec6 change = Vec6::Zero();
  change[2] = stretch;
  change[4] = curvature;
  change[5] = twist;
  return change;
}

// One tube for all motions: t/R = 0.1.
HeldTube thin_tube() {
  return {60, 6, 0.6, 24, 36};
}

void expect_settled(const CoupledSolution& solution) {
  EXPECT_EQ(solution.status, Status::converged) << to_string(solution.status);
  EXPECT_TRUE(solution.smallest_curvature_positive);
  EXPECT_LT(solution.surface.residual, 1e-9);
  EXPECT_LT(solution.surface.bodies[0].residual, 1e-6);
}

TEST(CoupledSolver, APullBetweenSoftEndsAnswersWithEATimesStrain) {
  const HeldTube tube = thin_tube();
  CoupledSolver solver(bent(tube, strain(1e-3, 0, 0), soft(tube.start()), soft(tube.end())));
  const CoupledSolution solution = solver.solve();
  expect_settled(solution);
  // The polygon of 24 sides has its mid-wall area; E = 1.
  const double area = 24 * 2 * 6 * std::sin(M_PI / 24) * 0.6;
  EXPECT_NEAR(solution.sections[0][1].force.z(), area * 1e-3, 0.005 * area * 1e-3);
  EXPECT_NEAR(solution.sections[0][0].force.z(), -solution.sections[0][1].force.z(), 1e-9 * area);
}

// A step that is too long for the iterations of one minimisation is halved, and leads to the
// minimum that it would have led to.
TEST(CoupledSolver, AStepThatFindsNoMinimumIsHalved) {
  const HeldTube tube = thin_tube();
  const double curvature = 0.6 * 0.471 * 0.6 / (36 * std::sqrt(0.91));
  const auto solved = [&](int most_iterations) {
    CoupledOptions options;
    options.times = {0.1, 1};
    options.max_iterations = most_iterations;
    const CoupledSolution solution =
        CoupledSolver(bent(tube, strain(0, curvature, 0), tube.start(), tube.end()), options)
            .solve();
    expect_settled(solution);
    EXPECT_EQ(solution.reached, 1);
    return solution;
  };
  const CoupledSolution whole = solved(100), halved = solved(10);
  EXPECT_EQ(whole.surface.outer_iterations, 2);
  EXPECT_GT(halved.surface.outer_iterations, 3);
  EXPECT_LT((halved.surface.bodies[0].positions - whole.surface.bodies[0].positions)
                .cwiseAbs()
                .maxCoeff(),
            1e-6 * 6);
}

TEST(CoupledSolver, ReactionsAreTheEnergysDerivativeAlongTheMotion) {
  // Bent to half the Brazier curvature between rigid ends, with a small additional rotation about
  // the end's centre.
  const HeldTube tube = thin_tube();
  const double curvature = 0.5 * 0.471 * 0.6 / (36 * std::sqrt(0.91));
  const auto solved = [&](double more) {
    CoupledProblem problem = bent(tube, strain(0.002, curvature, 0.001), tube.start(), tube.end());
    problem.vessels[0]->sections[1].motion.rotate *= 1 + more;
    return CoupledSolver(std::move(problem)).solve();
  };
  const double step = 1e-3;
  const CoupledSolution middle = solved(0), more = solved(step), less = solved(-step);
  expect_settled(middle);
  const auto energy = [](const CoupledSolution& s) { return s.membrane_energy + s.bending_energy; };
  const Vec3 axis = bent(tube, strain(0.002, curvature, 0.001), tube.start(), tube.end())
                        .vessels[0]
                        ->sections[1]
                        .motion.rotate;
  const double slope = (energy(more) - energy(less)) / (2 * step);
  EXPECT_NEAR(middle.sections[0][1].moment.dot(axis), slope, 1e-5 * slope);
}

CoupledSolution cantilever(const HeldTube& tube, double load) {
  HeldSection end = free_of_all(tube.end());
  end.force = Vec3(load, 0, 0);
  return CoupledSolver(bent(tube, strain(0, 0, 0), tube.start(), end)).solve();
}

// The answer stays proportional to the load even where the energy has lost its digits.
TEST(CoupledSolver, TinySideLoadsAreAnsweredInProportion) {
  const HeldTube tube = thin_tube();
  const double compliance = cantilever(tube, 1e-6).sections[0][1].center.x() / 1e-6;
  for (const double load : {3e-7, 1e-7, 3e-8, 1e-8, 3e-9, 1e-9, 1e-10, 1e-11}) {
    const CoupledSolution solution = cantilever(tube, load);
    expect_settled(solution);
    EXPECT_NEAR(solution.sections[0][1].center.x(), compliance * load, 1e-4 * compliance * load)
        << load;
    EXPECT_NEAR(solution.sections[0][0].force.x(), -load, 1e-3 * load) << load;
    EXPECT_NEAR(solution.sections[0][1].force.x(), load, 1e-3 * load) << load;
  }
}

// ... and where the forces have lost them too, the result says so. It is still the best state seen:
// its end follows its load.
TEST(CoupledSolver, LoadsThatRoundingHidesAreNamed) {
  const double load = 3e-13;
  const CoupledSolution solution = cantilever({30, 6, 0.6, 16, 14}, load);
  EXPECT_EQ(solution.status, Status::iteration_limit) << to_string(solution.status);
  ASSERT_EQ(solution.notes.size(), 2u);
  EXPECT_NE(solution.notes[0].find("rounding"), std::string::npos);
  EXPECT_NE(solution.notes[1].find("ended at 100 % of the way"), std::string::npos);
  EXPECT_NEAR(solution.sections[0][1].force.x(), load, 0.1 * load);
}

TEST(CoupledSolver, RigidMotionsCostNothing) {
  const HeldTube tube = thin_tube();
  HeldSection start = tube.start(), end = tube.end();
  const Vec3 turn(0.7, -0.4, 0.3), shift(5, -3, 2);
  const Mat3 rotation = exp_rotation(turn);
  start.motion = {turn, shift};
  end.motion = {turn, shift + rotation * Vec3(0, 0, 60) - Vec3(0, 0, 60)};
  CoupledProblem problem = bent(tube, Vec6::Zero(), start, end);
  problem.vessels[0]->sections = {start, end};
  problem.carried = [&](double) {
    CarriedBody body;
    body.points = (tube.surface.points * rotation.transpose()).rowwise() + shift.transpose();
    body.rotations.assign(static_cast<size_t>(body.points.rows()), rotation);
    body.sections = {{rotation, shift}, {rotation, shift + rotation * Vec3(0, 0, 60)}};
    return std::vector<CarriedBody>{body};
  };
  CoupledSolver solver(std::move(problem));
  const CoupledSolution solution = solver.solve();
  EXPECT_EQ(solution.status, Status::converged);
  EXPECT_LT(solution.membrane_energy + solution.bending_energy, 1e-20);
  const Points exact = (tube.surface.points * rotation.transpose()).rowwise() + shift.transpose();
  EXPECT_LT((solution.surface.bodies[0].positions - exact).cwiseAbs().maxCoeff(), 1e-9 * 6);
}

TEST(CoupledSolver, ADeadForceOnAFreeRigidEndBendsACantilever) {
  HeldTube tube(120, 6, 0.6, 24, 72);
  HeldSection end = free_of_all(tube.end());
  const double force = 1e-5;
  end.force = Vec3(force, 0, 0);
  CoupledSolver solver(bent(tube, Vec6::Zero(), tube.start(), end));
  const CoupledSolution solution = solver.solve();
  expect_settled(solution);
  // Timoshenko with Cowper's coefficient for a thin ring, k = 2 (1 + nu) / (4 + 3 nu).
  const double area = 2 * M_PI * 6 * 0.6, inertia = M_PI * 216 * 0.6 * (1 + 0.01 / 4);
  const double k = 2 * 1.3 / 4.9, shear = 1 / 2.6;
  const double exact = force * (std::pow(120, 3) / (3 * inertia) + 120 / (k * shear * area));
  EXPECT_NEAR(solution.sections[0][1].center.x(), exact, 0.01 * exact);
  EXPECT_NEAR(solution.sections[0][1].force.x(), force, 1e-6 * force);
  EXPECT_NEAR(solution.sections[0][0].moment.y(), -force * 120, 1e-5 * force * 120);
}

TEST(CoupledSolver, ADeadMomentOnASoftEndTurnsItByMLOverEI) {
  HeldTube tube(120, 6, 0.6, 24, 72);
  HeldSection end = free_of_all(soft(tube.end()));
  const double inertia = M_PI * 216 * 0.6 * (1 + 0.01 / 4), moment = inertia * 1e-5;
  end.moment = Vec3(0, moment, 0);
  CoupledSolver solver(bent(tube, Vec6::Zero(), tube.start(), end));
  const CoupledSolution solution = solver.solve();
  EXPECT_EQ(solution.status, Status::equilibrium_only)
      << "a dead moment in three dimensions has no energy";
  EXPECT_TRUE(solution.smallest_curvature_positive);
  EXPECT_NEAR(log_rotation(solution.sections[0][1].rotation).y(), 120 * 1e-5, 0.01 * 120 * 1e-5);
  EXPECT_NEAR(solution.sections[0][1].moment.y(), moment, 1e-6 * moment);
}

TEST(CoupledSolver, UnitsDoNotMatter) {
  const HeldTube tube = thin_tube();
  const Vec6 change = strain(0.002, 2e-3, 0.001);
  const CoupledSolution one = CoupledSolver(bent(tube, change, tube.start(), tube.end())).solve();
  // The same tube in a length unit a thousand times smaller and a stress unit a million times
  // larger.
  HeldTube other(60e3, 6e3, 0.6e3, 24, 36);
  other.wall.material = Material::isotropic(1e-6, 0.3);
  Vec6 small = change;
  small.tail<3>() *= 1e-3;
  CoupledProblem problem = bent(other, small, other.start(), other.end());
  problem.surfaces.bodies[0].k = {1e-3, 1e-4, 0.4 * 0.6e-3};
  const CoupledSolution two = CoupledSolver(std::move(problem)).solve();
  EXPECT_EQ(two.status, Status::converged);
  EXPECT_LT((one.surface.bodies[0].positions - 1e-3 * two.surface.bodies[0].positions)
                .cwiseAbs()
                .maxCoeff(),
            1e-8 * 6);
  EXPECT_NEAR(two.sections[0][1].moment.y() / 1e3, one.sections[0][1].moment.y(),
              1e-8 * std::abs(one.sections[0][1].moment.y()));
}

TEST(CoupledSolver, AnotherMotionIsSolvedFromTheLastOneAsFromRest) {
  const HeldTube tube = thin_tube();
  CoupledSolver kept(bent(tube, strain(0, 1e-3, 0), tube.start(), tube.end()));
  kept.solve();
  const Vec6 change = strain(0.003, 2e-3, 0.002);
  CoupledProblem next = bent(tube, change, tube.start(), tube.end());
  kept.set_sections(0, next.vessels[0]->sections);
  kept.set_carried(next.carried);
  const CoupledSolution again = kept.solve();
  const CoupledSolution fresh = CoupledSolver(std::move(next)).solve();
  expect_settled(again);
  EXPECT_LT(
      (again.surface.bodies[0].positions - fresh.surface.bodies[0].positions).cwiseAbs().maxCoeff(),
      1e-7 * 6);
}

TEST(CoupledSolver, AnotherMaterialIsSolvedAsFromRest) {
  const Vec6 change = strain(0.002, 2e-3, 0.002);
  Material soft_in_shear = Material::isotropic(2, 0.2);  // its director leans beside the rims
  soft_in_shear.shear_axial /= 20;
  for (const Material& other : {Material::isotropic(2, 0.2), soft_in_shear}) {
    HeldTube tube = thin_tube();
    CoupledSolver kept(bent(tube, change, tube.start(), tube.end()));
    const CoupledSolution before = kept.solve();
    kept.set_material(0, other);
    const CoupledSolution again = kept.solve();
    const Material first = tube.wall.material;
    tube.wall.material = other;
    WallInput wall = tube.wall;
    wall.glued = glued_marks({tube.start(), tube.end()}, wall.rest.points.rows());
    EXPECT_EQ(shear_band(wall).size() > 0, !other.is_isotropic());
    const CoupledSolution fresh =
        CoupledSolver(bent(tube, change, tube.start(), tube.end())).solve();
    expect_settled(again);
    EXPECT_NEAR(again.sections[0][1].moment.y(), fresh.sections[0][1].moment.y(),
                1e-7 * std::abs(fresh.sections[0][1].moment.y()));
    kept.set_material(0, first);
    EXPECT_NEAR(kept.solve().sections[0][1].moment.y(), before.sections[0][1].moment.y(),
                1e-7 * std::abs(before.sections[0][1].moment.y()));
  }
}

TEST(CoupledSolver, AWallThatNothingHoldsIsRefusedWithItsFreeMotion) {
  const HeldTube tube = thin_tube();
  HeldSection start = tube.start(), end = tube.end();
  start.fixed = {true, true, true, false, false, false};
  end.fixed = {true, true, false, false, false, false};
  end.force = Vec3(0, 0, 1e-3);
  try {
    CoupledSolver solver(bent(tube, Vec6::Zero(), start, end));
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("vessel tube"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("rotation about the axis (0, 0, "), std::string::npos)
        << error.what();
  }
}

TEST(CoupledSolver, StoppedItKeepsTheBestState) {
  const HeldTube tube = thin_tube();
  CoupledOptions options;
  int iterations = 0;
  options.progress = [&](const SolverProgress& at) { iterations = at.iterations; };
  options.stop = [&] { return iterations >= 2; };
  CoupledSolver solver(bent(tube, strain(0, 2e-3, 0), tube.start(), tube.end()), options);
  const CoupledSolution solution = solver.solve();
  EXPECT_EQ(solution.status, Status::interrupted);
  EXPECT_TRUE(solution.surface.bodies[0].positions.allFinite());
  EXPECT_TRUE(std::isfinite(solution.membrane_energy));
}

// At the first, a middle and the last question that is asked within a factorisation; the solver
// then solves as ever.
TEST(CoupledSolver, StoppedWithinAFactorisationItKeepsTheStateBefore) {
  const HeldTube tube = thin_tube();
  CoupledOptions options;
  bool within = false;
  int asked = 0, last = 0;
  options.step = [&](const std::string&) { within = true; };
  options.progress = [&](const SolverProgress&) { within = false; };
  options.stop = [&] { return within && ++asked == last; };
  const auto problem = [&] { return bent(tube, strain(0, 2e-3, 0), tube.start(), tube.end()); };
  const CoupledSolution whole = CoupledSolver(problem(), options).solve();
  ASSERT_EQ(whole.status, Status::converged);
  const int questions = asked;
  ASSERT_GT(questions, 10);
  for (const int at : {1, questions / 2, questions}) {
    asked = 0;
    last = at;
    CoupledSolver solver(problem(), options);
    const CoupledSolution solution = solver.solve();
    EXPECT_EQ(solution.status, Status::interrupted) << at;
    EXPECT_EQ(asked, at) << "it went on";
    EXPECT_TRUE(solution.surface.bodies[0].positions.allFinite());
    EXPECT_FALSE(solution.smallest_curvature_positive);
    last = 0;
    const CoupledSolution after = solver.solve();
    EXPECT_EQ(after.status, Status::converged) << at;
    EXPECT_LT((after.surface.bodies[0].positions - whole.surface.bodies[0].positions)
                  .cwiseAbs()
                  .maxCoeff(),
              1e-6 * tube.tube.radius);
  }
}

}  // namespace
}  // namespace vasorod
