#include <gtest/gtest.h>
#include <limits>
#include <numbers>

#include <vasorod/error.h>

#include "coupled/coupled_contacts.h"
#include "coupled/joined_tubes.h"
#include "coupled/seam_closing.h"
#include "geometry/closest_point.h"

namespace vasorod {
namespace {

using namespace testing;

// Two tubes with a gap between their rims, held at their far ends.
CoupledProblem two_tubes(const Vec3& apart, double unit = 1) {
  const HeldTube half(30 * unit, 6 * unit, 0.6 * unit, 24, 18);
  CoupledProblem problem;
  add_tube(problem, half, "lower", Vec3::Zero(), {half.start()});
  add_tube(problem, half, "upper", unit * (Vec3(0, 0, 30) + apart), {half.end()});
  for (const int v : half.row(0)) problem.surfaces.seams.push_back({1, v, 0, v + 18 * 24});
  for (SurfaceBody& body : problem.surfaces.bodies)
    body.k = {unit, 0.1 * unit, body.k.stretching};  // force / length, as is E t
  carry_by_sections(problem);
  return problem;
}

// `way`: the step of the time on which the seam is brought together; 0: its start is closed.
CoupledSolution pulled_together(const Vec3& apart, double way, double unit = 1,
                                const CoupledOptions& options = {}) {
  CoupledProblem problem = two_tubes(apart, unit);
  if (way > 0)
    problem.seam_way = SeamWay{[apart, unit, n = problem.surfaces.seams.size()](double t) {
                                 return std::vector<Vec3>(n, (1 - t) * unit * apart);
                               },
                               way};
  CoupledSolver solver(std::move(problem), options);
  return solver.solve();
}

double largest_difference(const CoupledSolution& a, const CoupledSolution& b) {
  double largest = 0;
  for (size_t body = 0; body < a.surface.bodies.size(); ++body)
    largest =
        std::max(largest, (a.surface.bodies[body].positions - b.surface.bodies[body].positions)
                              .rowwise()
                              .norm()
                              .maxCoeff());
  return largest;
}

// Where nothing folds there is one minimum, whatever the way to it.
TEST(SeamClosing, ItEndsInTheMinimumOfAClosedStart) {
  for (const Vec3& apart : {Vec3(0, 0, 3), Vec3(1.5, -1, 2)}) {
    const CoupledSolution closed = pulled_together(apart, 0);
    ASSERT_EQ(closed.status, Status::converged);
    for (const double step : {0.1, 0.5}) {
      const CoupledSolution way = pulled_together(apart, step);
      EXPECT_EQ(way.status, Status::converged);
      EXPECT_TRUE(way.smallest_curvature_positive);
      EXPECT_LT(largest_difference(way, closed), 1e-5 * 6);
      EXPECT_NEAR(way.sections[1][0].force.z(), closed.sections[1][0].force.z(),
                  1e-5 * std::abs(closed.sections[1][0].force.z()));
    }
  }
}

TEST(SeamClosing, TheUnitDoesNotMatter) {
  const CoupledSolution mm = pulled_together({1.5, -1, 2}, 0.25),
                        m = pulled_together({1.5, -1, 2}, 0.25, 1e-3);
  ASSERT_EQ(m.status, mm.status);
  EXPECT_EQ(m.surface.outer_iterations, mm.surface.outer_iterations);
  EXPECT_LT((m.surface.bodies[1].positions * 1e3 - mm.surface.bodies[1].positions)
                .rowwise()
                .norm()
                .maxCoeff(),
            1e-6 * 6);
}

TEST(SeamClosing, TheCertificateSaysInHowManySteps) {
  const CoupledSolution way = pulled_together({0, 0, 3}, 0.25);
  ASSERT_EQ(way.notes.size(), 1u);
  EXPECT_EQ(way.notes[0],
            "the seam was brought together along a way of 4 steps, as the vessel "
            "folds");
  EXPECT_EQ(way.reached, 1);
}

TEST(SeamClosing, ASolveWhoseFactorisationsAreSpentEndsAtItsNextUpdate) {
  const CoupledSolution whole = pulled_together({1.5, -1, 2}, 0);
  ASSERT_EQ(whole.status, Status::converged);
  ASSERT_GT(whole.surface.outer_iterations, 1);
  CoupledOptions options;
  options.most_per_stage = 1;
  const CoupledSolution spent = pulled_together({1.5, -1, 2}, 0, 1, options);
  EXPECT_EQ(spent.status, Status::iteration_limit);
  EXPECT_EQ(spent.surface.outer_iterations, 1);
  options.most_per_stage = static_cast<int>(whole.surface.work.counts.factorisations) + 1;
  EXPECT_EQ(pulled_together({1.5, -1, 2}, 0, 1, options).status, Status::converged);
}

// Pressure at which the hoop strain p R / (E t) is 0.05; E is 1.
constexpr double inflation = 0.05 * 0.6 / 6;
const char* const still_inflated =
    "the vessels are still inflated, by a pressure that is not the scene's";

CoupledSolution inflated(double pressure, std::optional<LumenPressure> lumen = {}) {
  CoupledProblem problem = two_tubes({1.5, -1, 2});
  for (const auto& vessel : problem.vessels) {
    vessel->inflation = pressure;
    vessel->pressure = lumen;
  }
  return CoupledSolver(std::move(problem)).solve();
}

TEST(SeamClosing, InflationIsPressureInTheLumen) {
  const CoupledSolution mine = inflated(inflation),
                        pressed = inflated(0, LumenPressure{0, inflation}),
                        both = inflated(inflation / 2, LumenPressure{0, inflation / 2});
  ASSERT_EQ(mine.status, Status::converged);
  ASSERT_EQ(pressed.status, Status::converged);
  ASSERT_EQ(mine.notes.size(), 1u);
  EXPECT_EQ(mine.notes[0], still_inflated);
  EXPECT_TRUE(pressed.notes.empty());
  EXPECT_LT(largest_difference(mine, pressed), 1e-7 * 6);
  EXPECT_LT(largest_difference(both, pressed), 1e-7 * 6);
  EXPECT_GT(largest_difference(mine, inflated(0)), 0.02 * 6);
}

CoupledProblem inflated_start(const CoupledSolution& round) {
  CoupledProblem problem = two_tubes({1.5, -1, 2});
  CoupledStart& start = problem.start.emplace();
  for (size_t b = 0; b < 2; ++b) {
    problem.vessels[b]->inflation = inflation;
    start.bodies.emplace_back().points = round.surface.bodies[b].positions;
    start.pressure.push_back(round.surface.bodies[b].pressure);
    for (const SectionSolution& section : round.sections[b])
      start.bodies[b].sections.push_back({section.rotation, section.center});
  }
  start.roughness = Roughness::near;
  problem.lets_out = true;
  return problem;
}

// Nothing folds, so that there is one minimum.
TEST(SeamClosing, WhatIsLetOutEndsInTheMinimumThatWasNeverInflated) {
  CoupledProblem problem = inflated_start(inflated(inflation));
  problem.meet_up_to_seams = true;
  const CoupledSolution let_out = CoupledSolver(std::move(problem)).solve(), closed = inflated(0);
  ASSERT_EQ(let_out.status, Status::converged);
  EXPECT_TRUE(let_out.smallest_curvature_positive);
  EXPECT_LT(largest_difference(let_out, closed), 1e-5 * 6);
  EXPECT_NEAR(let_out.membrane_energy, closed.membrane_energy, 1e-6 * closed.membrane_energy);
  ASSERT_EQ(let_out.notes.size(), 1u);
  EXPECT_EQ(let_out.notes[0],
            "the vessels were joined inflated, as the vein folds, and then let out");
}

TEST(SeamClosing, EachStageOfWallsThatAreLetOutHasItsOwnFactorisations) {
  const auto solved = [round = inflated(inflation)](int most) {
    CoupledProblem problem = inflated_start(round);
    problem.meet_up_to_seams = true;
    CoupledOptions options;
    options.most_per_stage = most;
    return CoupledSolver(std::move(problem), options).solve();
  };
  const auto whole = static_cast<int>(solved(0).surface.work.counts.factorisations);
  ASSERT_GT(whole, 2);
  EXPECT_EQ(solved(whole - 1).status, Status::converged);
}

TEST(SeamClosing, WhatIsNotLetOutInItsFactorisationsIsNoMinimum) {
  CoupledOptions options;
  options.most_per_stage = 1;
  CoupledSolver solver(inflated_start(inflated(inflation)), options);
  const CoupledSolution spent = solver.solve();
  EXPECT_EQ(spent.status, Status::iteration_limit);
  EXPECT_EQ(solver.solve().surface.work.counts.factorisations,
            spent.surface.work.counts.factorisations);
  ASSERT_EQ(spent.notes.size(), 2u);
  EXPECT_EQ(spent.notes[0],
            "walls that were joined inflated could not be let out, and no equilibrium was found");
  EXPECT_EQ(spent.notes[1], still_inflated);
}

TEST(SeamClosing, OnlyAnInflatedStartCanBeLetOut) {
  CoupledProblem problem = two_tubes({1.5, -1, 2});
  problem.lets_out = true;
  try {
    CoupledSolver(std::move(problem)).solve();
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(),
                 "walls to be let out: found no start, expected that of inflated walls");
  }
}

// Walls that are said to pass through each other at a minimum near the start.
struct Asked {
  int times = 0;
  std::vector<Points> now;
  CoupledSolution solution;
};

Asked asked(const CoupledSolution& found, bool passes_through, double unit) {
  Asked asked;
  CoupledProblem problem = two_tubes({1.5, -1, 2}, unit);
  CoupledStart& start = problem.start.emplace();
  for (const BodySolution& body : found.surface.bodies) {
    start.bodies.emplace_back().points = body.positions;
    start.pressure.push_back(body.pressure);
  }
  CoupledOptions options;
  options.passes_through = [&](const std::vector<Points>& now) {
    ++asked.times;
    asked.now = now;
    return passes_through;
  };
  asked.solution = CoupledSolver(std::move(problem), options).solve();
  return asked;
}

// Nothing lies in anything, so that the minimum stays.
TEST(SeamClosing, WhatPassesThroughAtAStartIsPartedOnceAndFindsItsMinimum) {
  for (const double unit : {1.0, 1e-3}) {
    const CoupledSolution found = pulled_together({1.5, -1, 2}, 0, unit);
    for (const bool passes : {false, true}) {
      const Asked parted = asked(found, passes, unit);
      EXPECT_EQ(parted.times, 1);
      ASSERT_EQ(parted.now.size(), 2u);
      for (size_t b = 0; b < 2; ++b)
        EXPECT_LT((parted.now[b] - found.surface.bodies[b].positions).rowwise().norm().maxCoeff(),
                  1e-2 * 6 * unit);
      EXPECT_EQ(parted.solution.status, Status::converged);
      EXPECT_TRUE(parted.solution.smallest_curvature_positive);
      EXPECT_TRUE(parted.solution.notes.empty());
      EXPECT_LT(largest_difference(parted.solution, found), 1e-5 * 6 * unit);
    }
  }
}

// The end of a third tube stands beside joined ones, by their seam, pressed into one of them by
// 0.03, which nothing knows yet.
TEST(SeamClosing, WhatIsTouchedInAPatchJoinsThePatch) {
  CoupledProblem problem = joined_tubes();
  const Vec3 there(2 * joined_radius + joined_thickness + 0.01 - 40, 0, 26.5);
  problem.surfaces.bodies[2].rest.points.rowwise() += there.transpose();
  for (HeldSection& section : problem.vessels[2]->sections) section.rest.position += there;
  problem.vessels[2]->wall.rest = problem.surfaces.bodies[2].rest;
  problem.surfaces.contacts = {{0, 2}};
  for (size_t b = 0; b < 2; ++b) problem.start->bodies[b].points.col(0).array() += 0.04;
  problem.start->bodies[2].points.resize(0, 3);
  carry_by_sections(problem);
  CoupledStack stack(std::move(problem), {});
  CoupledPath path(stack);
  put_at_start(stack, path);
  ASSERT_FALSE(stack.scaled.bodies[2].modelled);
  int narrow = 0, wide = 0;
  SeamClosing closing(stack, path, {}, [&](const CoupledMinimiserSummary&) {
    (stack.is_narrow() ? narrow : wide) += 1;
  });
  EXPECT_EQ(closing.part(), Status::converged);
  EXPECT_TRUE(stack.scaled.bodies[2].modelled);
  EXPECT_FALSE(stack.is_narrow());
  EXPECT_GT(narrow, 1);
  EXPECT_EQ(wide, 0);
}

// A roof whose ridge runs along the wall between two columns of vertices. `out`: from the axis
// through the ridge, unit.
TriangleSurface roof(const Vec3& ridge, const Vec3& out, int along, double step) {
  const Vec3 aside = Vec3::UnitZ().cross(out);
  TriangleSurface roof;
  roof.points.resize(3 * (along + 1), 3);
  roof.triangles.resize(4 * along, 3);
  for (int k = 0; k <= along; ++k) {
    const Vec3 top = ridge + k * step * Vec3::UnitZ();
    roof.points.row(3 * k) = top + 8 * (out + aside);
    roof.points.row(3 * k + 1) = top;
    roof.points.row(3 * k + 2) = top + 8 * (out - aside);
  }
  for (int k = 0; k < along; ++k)
    for (int side = 0; side < 2; ++side) {
      const int a = 3 * k + side, b = a + 1;
      roof.triangles.row(4 * k + 2 * side) << a, b, a + 3;
      roof.triangles.row(4 * k + 2 * side + 1) << b, b + 3, a + 3;
    }
  return roof;
}

// The wall is pulled towards the ridge. Its vertices pass beside it, over the sides, where they
// would meet them only when the ridge is through the wall.
TEST(SeamClosing, AnObstaclesVerticesAreLookedAtOnceTheSeamIsClosed) {
  const double radius = 6, thickness = 0.6, mid = std::numbers::pi / 24;
  const HeldTube half(30, radius, thickness, 24, 18);
  const Vec3 apart(3, 0, 2);
  const Vec3 out(-std::cos(mid), -std::sin(mid), 0);
  CoupledProblem problem;
  add_tube(problem, half, "lower", Vec3::Zero(), {half.start()});
  add_tube(problem, half, "upper", Vec3(0, 0, 30) + apart, {half.end()});
  for (const int v : half.row(0)) problem.surfaces.seams.push_back({1, v, 0, v + 18 * 24});
  add_obstacle(
      problem, "roof",
      roof(apart + Vec3(0, 0, 34) + (radius * std::cos(mid) + thickness) * out, out, 16, 0.5));
  problem.surfaces.contacts.emplace_back(1, 2);
  carry_by_sections(problem);
  problem.seam_way = SeamWay{[apart, n = problem.surfaces.seams.size()](double t) {
                               return std::vector<Vec3>(n, (1 - t) * apart);
                             },
                             0.25};
  const Points ridge = problem.surfaces.bodies[2].rest.points(Eigen::seqN(1, 17, 3), Eigen::all);
  TriangleSurface upper = problem.surfaces.bodies[1].rest;
  CoupledSolver solver(std::move(problem));
  const CoupledSolution s = solver.solve();
  ASSERT_EQ(s.status, Status::converged);
  upper.points = s.surface.bodies[1].positions;
  const ClosestPoint wall(upper);
  double nearest = std::numeric_limits<double>::infinity();
  for (int k = 0; k < ridge.rows(); ++k)
    nearest = std::min(nearest, wall.query(ridge.row(k)).signed_distance);
  EXPECT_NEAR(nearest, thickness / 2, 0.02 * thickness);
}

TEST(SeamClosing, StoppedItKeepsTheLastState) {
  const HeldTube half(30, 6, 0.6, 24, 18);
  CoupledProblem problem;
  add_tube(problem, half, "lower", Vec3::Zero(), {half.start()});
  add_tube(problem, half, "upper", Vec3(0, 0, 33), {half.end()});
  for (const int v : half.row(0)) problem.surfaces.seams.push_back({1, v, 0, v + 18 * 24});
  carry_by_sections(problem);
  problem.seam_way = SeamWay{[n = problem.surfaces.seams.size()](double t) {
                               return std::vector<Vec3>(n, (1 - t) * Vec3(0, 0, 3));
                             },
                             0.25};
  CoupledOptions options;
  int asked = 0;
  options.stop = [&] { return ++asked > 12; };
  CoupledSolver solver(std::move(problem), options);
  const CoupledSolution s = solver.solve();
  EXPECT_EQ(s.status, Status::interrupted);
  EXPECT_LT(s.reached, 1);
  EXPECT_TRUE(s.surface.bodies[1].positions.allFinite());
}

}  // namespace
}  // namespace vasorod
