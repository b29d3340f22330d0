#include <gtest/gtest.h>
#include <numbers>

#include <vasorod/error.h>
#include <vasorod/tube.h>

#include "geometry/rigid_motion.h"
#include "sections/section_solver.h"
#include "straight_tube.h"

namespace vasorod {
namespace {

using testing::straight_tube;

constexpr double length = 10, radius = 1, thickness = 0.1;

struct Tube {
  Vessel vessel;
  SectionProblem problem;
  /// Lengths times `unit`, E = `young`.
  explicit Tube(double unit = 1, double young = 1, double extent = length, int along = 24) {
    vessel =
        fit_vessel("tube", tube_surface(straight_tube(extent * unit, radius * unit, 24, along)));
    problem.name = "tube";
    problem.rest = vessel.surface.points;
    problem.at = section_parameters(vessel, "");
    problem.thickness = Eigen::VectorXd::Constant(problem.rest.rows(), thickness * unit);
    problem.material = Material::isotropic(young, 0.3);
    problem.radius = radius * unit;
    problem.length = extent * unit;
    for (size_t e = 0; e < 2; ++e) {
      HeldSection& end = problem.ends[e].emplace();
      end.label = e == 0 ? "start" : "end";
      end.rest =
          vessel.rod
              .rest[static_cast<size_t>(vessel.ends[static_cast<size_t>(problem.at.end[e])].node)];
    }
    problem.start = [this](double) {
      SectionProblem::Start start{problem.rest, {}};
      for (size_t e = 0; e < 2; ++e) {
        const Pose& rest = problem.ends[e]->rest;
        const RodMotion& motion = problem.ends[e]->motion;
        start.poses[e] = {exp_rotation(motion.rotate), rest.position + motion.move};
      }
      return start;
    };
  }
  HeldSection& end() { return *problem.ends[1]; }
};

TEST(SectionSolver, AtRestItStaysAndIsAMinimum) {
  Tube tube;
  const SolvedSections found = solve_sections(tube.problem);
  EXPECT_EQ(found.status, Status::converged);
  EXPECT_TRUE(found.smallest_curvature_positive);
  EXPECT_LT((found.positions - tube.problem.rest).cwiseAbs().maxCoeff(), 1e-8);
  EXPECT_LT(found.ends[0]->force.norm() + found.ends[1]->moment.norm(), 1e-9);
}

// E A e of a wall that may narrow, with soft ends: nothing holds its rims apart.
TEST(SectionSolver, ASoftlyPulledTubeStretchesAsABarDoes) {
  Tube tube;
  const double strain = 1e-4;
  for (auto& end : tube.problem.ends) end->rigid = false;
  tube.end().motion.move = {0, 0, strain * length};
  const SolvedSections found = solve_sections(tube.problem);
  EXPECT_EQ(found.status, Status::converged);
  const double area = 2 * std::numbers::pi * radius * thickness;
  EXPECT_NEAR(found.ends[1]->force.z() / (area * strain), 1, 1e-4);
  EXPECT_LT(found.balance, 1e-8);
  // It narrows by Poisson's ratio.
  EXPECT_NEAR(found.positions.leftCols<2>().rowwise().norm().mean(), 1 - 0.3 * strain, 2e-6);
}

TEST(SectionSolver, UnitsDoNotMatter) {
  Tube small, large(1000, 1e6);
  const double angle = 0.1;
  for (Tube* tube : {&small, &large}) {
    tube->end().motion.rotate = {0, angle, 0};
    tube->end().motion.move = Vec3(0.3, 0, -0.01) * (tube == &small ? 1 : 1000);
  }
  const SolvedSections a = solve_sections(small.problem), b = solve_sections(large.problem);
  EXPECT_EQ(a.status, Status::converged);
  EXPECT_EQ(a.harmonics, b.harmonics);
  EXPECT_EQ(a.spans, b.spans);
  EXPECT_LT((1000 * a.positions - b.positions).cwiseAbs().maxCoeff(), 1000 * 1e-7);
  EXPECT_LT((1e12 * a.ends[1]->force - b.ends[1]->force).norm(), 1e-6 * b.ends[1]->force.norm());
}

// A tube two hundred times as long as wide: between the vertices of its many rings the shape at
// rest has no waves, which rounding errors would else be.
TEST(SectionSolver, ALongTubeIsStrainedAsItsBendSays) {
  Tube tube(1, 1, 200, 400);
  const double angle = 0.3;
  tube.end().motion.rotate = {0, angle, 0};
  tube.end().motion.move = {200 * (1 - std::cos(angle)) / angle, 0,
                            200 * (std::sin(angle) / angle - 1)};
  const SolvedSections found = solve_sections(tube.problem);
  EXPECT_EQ(found.status, Status::converged);
  EXPECT_LT(found.fit_error, 1e-6);
  EXPECT_LT(found.report.faces.largest, 1 + 4 * angle / 200);
}

// Finer spaces come nearer; the estimate bounds what is left.
TEST(SectionSolver, TheEstimateHoldsAgainstAFinerSolution) {
  Tube tube;
  tube.end().motion.rotate = {0, 0.25, 0};
  tube.end().motion.move = {1.2, 0, -0.1};
  SectionOptions fine;
  fine.error = 1e-7;
  const SolvedSections truth = solve_sections(tube.problem, fine);
  double before = 1;
  for (const double error : {1e-2, 1e-3, 1e-4}) {
    SectionOptions options;
    options.error = error;
    const SolvedSections found = solve_sections(tube.problem, options);
    EXPECT_EQ(found.status, Status::converged);
    const double rms =
        std::sqrt((found.positions - truth.positions).rowwise().squaredNorm().mean());
    EXPECT_LE(found.error, error);
    EXPECT_LE(rms, 1.5 * found.error) << error;
    EXPECT_LE(rms, before);
    before = rms;
  }
}

TEST(SectionSolver, AWallThatNothingHoldsAndOptionsThatSayNothingAreRefused) {
  Tube tube;
  tube.problem.ends[0].reset();
  tube.end().fixed = {true, true, true, true, true, false};
  EXPECT_THROW(solve_sections(tube.problem), InputError);
  Tube far;
  far.problem.length = 301;
  EXPECT_THROW(solve_sections(far.problem), InputError);
  SectionOptions options;
  options.error = 0;
  EXPECT_THROW(solve_sections(Tube().problem, options), InputError);
}

TEST(SectionSolver, IsInterruptedWithTheStateSoFar) {
  Tube tube;
  tube.end().motion.move = {1, 0, 0};
  SectionOptions options;
  options.stop = [] { return true; };
  const SolvedSections found = solve_sections(tube.problem, options);
  EXPECT_EQ(found.status, Status::interrupted);
  EXPECT_TRUE(found.positions.allFinite());
}

}  // namespace
}  // namespace vasorod
