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

// Lame's thick tube in plane strain: the mid-wall moves by u(R), which of R 10, t 1 at a pressure
// of E / 100 is .881404 (nu .3) and .746255 (nu .5). The held ends feel 2 nu p pi r_i^2. The lumen
// leaves terms in (t / R)^2 out.
TEST(SectionSolver, ATubeUnderPressureWidensAsLameSays) {
  const double pressure = 1e-7;
  for (const double nu : {0.0, 0.3, 0.5}) {
    Tube tube(10);  // R 10, t 1
    tube.problem.material = Material::isotropic(1, nu);
    tube.problem.pressure = {0, pressure};
    for (auto& end : tube.problem.ends) end->rigid = false;
    const SolvedSections found = solve_sections(tube.problem);
    EXPECT_EQ(found.status, Status::converged);
    const double a = 9.5, b = 10.5;
    const double exact =
        (1 + nu) * pressure * a * a / (b * b - a * a) * ((1 - 2 * nu) * 10 + b * b / 10);
    const Points moved = found.positions - tube.problem.rest;
    double widening = 0;
    for (Eigen::Index v = 0; v < moved.rows(); ++v)
      widening += moved.row(v).head<2>().dot(tube.problem.rest.row(v).head<2>()) / 10 /
                  double(moved.rows());
    EXPECT_NEAR(widening / exact, 1, 5e-3) << nu;
    const double lid = pressure * std::numbers::pi * a * a;
    EXPECT_NEAR(found.ends[1]->force.z(), 2 * nu * lid, 5e-3 * lid) << nu;
    EXPECT_LT(found.balance, 1e-6);
  }
}

// A wall under the pressure and the stretch it was seen at stays as it is, in every space.
TEST(SectionSolver, TheSeenShapeDoesNotDrift) {
  for (const bool rigid : {true, false})
    for (const double error : {1e-2, 1e-12}) {
      Tube tube;
      // Oval, tapered, bent.
      for (Eigen::Index v = 0; v < tube.problem.rest.rows(); ++v) {
        Vec3 p = tube.problem.rest.row(v);
        p.head<2>() *= 1 - 0.02 * p.z();
        p.x() *= 1.2;
        const double turn = p.z() / 10;
        tube.problem.rest.row(v) =
            Vec3(10 - (10 - p.x()) * std::cos(turn), p.y(), (10 - p.x()) * std::sin(turn));
      }
      tube.end().rest.position = Vec3(10 - 10 * std::cos(1.0), 0, 10 * std::sin(1.0));
      tube.end().rest.rotation = exp_rotation(Vec3(0, 1, 0));
      for (auto& end : tube.problem.ends) end->rigid = rigid;
      tube.problem.pressure = {0.004, 0.004};
      tube.problem.axial_prestretch = rigid ? 1.08 : 1.01;
      SectionOptions options;
      options.error = error;
      const SolvedSections found = solve_sections(tube.problem, options);
      EXPECT_EQ(found.status, Status::converged)
          << rigid << (found.notes.empty() ? "" : found.notes[0]);
      EXPECT_GT(found.prestress_displacement, 0.01);
      EXPECT_LT((found.positions - tube.problem.rest).rowwise().norm().maxCoeff(), 1e-9) << rigid;
    }
}

// A ring collapses at p = 3 D / R^3. Free edges are softer: a tube as long as its radius comes
// within 5 %.
TEST(SectionSolver, ARingCollapsesAtItsPressure) {
  const double t = 0.05, nu = 0.3, critical = 3 * t * t * t / (12 * (1 - nu * nu));
  for (const double share : {0.95, 1.05}) {
    Tube tube(1, 1, 1, 6);
    tube.problem.thickness.setConstant(t);
    for (auto& end : tube.problem.ends) end->rigid = false;
    tube.problem.pressure = {0, -share * critical};
    tube.problem.times = {0.5, 1};
    const SolvedSections found = solve_sections(tube.problem);
    EXPECT_EQ(found.smallest_curvature_positive, share < 1);
    EXPECT_EQ(found.status, share < 1 ? Status::converged : Status::unstable)
        << share << (found.notes.empty() ? "" : found.notes[0]);
  }
}

// Bent to a fifth of Brazier's curvature, seen at the pressure: a section flattens 1 + p / p_c
// times less than without one. Soft ends flatten more, by less than a hundredth in the middle of
// twenty radii.
TEST(SectionSolver, PressureKeepsABentTubeRound) {
  const double nu = 0.5, critical = 3 * thickness * thickness * thickness / (12 * (1 - nu * nu));
  const double curvature = 0.2 * 0.471 * thickness / std::sqrt(1 - nu * nu), angle = 20 * curvature;
  double empty = 0;
  for (const double ratio : {0.0, 1.0, 5.0}) {
    Tube tube(1, 1, 20, 48);
    tube.problem.material = Material::isotropic(1, nu);
    tube.problem.pressure = {ratio * critical, ratio * critical};
    for (auto& end : tube.problem.ends) end->rigid = false;
    tube.end().motion.rotate = {0, angle, 0};
    tube.end().motion.move = {(1 - std::cos(angle)) / curvature, 0,
                              std::sin(angle) / curvature - 20};
    const SolvedSections found = solve_sections(tube.problem);
    EXPECT_EQ(found.status, Status::converged);
    // Of the section in the middle: its height in the plane of the bend against its width.
    double low = 1e9, high = -1e9, wide = 0;
    const Vec3 center((1 - std::cos(angle / 2)) / curvature, 0, std::sin(angle / 2) / curvature);
    const Vec3 across(std::cos(angle / 2), 0, -std::sin(angle / 2));
    for (Eigen::Index v = 0; v < found.positions.rows(); ++v) {
      if (std::abs(tube.problem.rest(v, 2) - 10) > 1e-6) continue;
      const Vec3 p = Vec3(found.positions.row(v)) - center;
      low = std::min(low, p.dot(across));
      high = std::max(high, p.dot(across));
      wide = std::max(wide, 2 * std::abs(p.y()));
    }
    const double flattening = 1 - (high - low) / wide;
    if (ratio == 0) empty = flattening;
    EXPECT_NEAR(flattening / empty * (1 + ratio), 1, 0.01) << ratio;
  }
  EXPECT_GT(empty, 0.01);
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
