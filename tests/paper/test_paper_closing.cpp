#include <gtest/gtest.h>

#include "judge/crossings.h"
#include "paper/paper_solver.h"
#include "paper/paper_tubes.h"

namespace vasorod {
namespace {

using namespace testing;
constexpr double pi = std::numbers::pi;
constexpr int around = 24, along = 16;
constexpr double radius = 6, length = 28;

SurfaceBody body_of(const std::string& name, const Points& carried_by, double unit) {
  SurfaceBody body;
  body.name = name;
  body.rest = tube(radius * unit, length * unit, around, along);
  body.rest.points.rowwise() += unit * carried_by.row(0);
  body.thickness = 0.6 * unit;
  body.offset = 0.3 * unit;
  body.k = {0.02 / unit, 1 / unit, 0.3 / unit};
  body.fixed.assign(static_cast<size_t>(body.rest.points.rows()), 0);
  return body;
}

void fix_ring(SurfaceBody& body, int first) {
  for (int k = 0; k < around; ++k) body.fixed[static_cast<size_t>(first + k)] = 1;
}

// Two tubes with a gap between their rims, held at their far ends by rods that do not move.
BodyProblem two_tubes(const Eigen::RowVector3d& apart, double unit = 1) {
  BodyProblem problem;
  problem.bodies = {body_of("lower", Eigen::RowVector3d::Zero(), unit),
                    body_of("upper", Eigen::RowVector3d(0, 0, length) + apart, unit)};
  fix_ring(problem.bodies[0], 0);
  fix_ring(problem.bodies[1], around * along);
  for (int k = 0; k < around; ++k) problem.seams.push_back({1, k, 0, k + around * along});
  return problem;
}

PaperWay way_of(const BodyProblem& problem, const Eigen::RowVector3d& apart, double step) {
  PaperWay way;
  way.carried = [count = problem.bodies.size()](double) { return std::vector<CarriedBody>(count); };
  way.seam.offsets = [apart, count = problem.seams.size()](double t) {
    return std::vector<Vec3>(count, (1 - t) * apart.transpose());
  };
  way.seam.step = step;
  return way;
}

double largest_difference(const SurfaceSolution& a, const SurfaceSolution& b) {
  double largest = 0;
  for (size_t body = 0; body < a.bodies.size(); ++body)
    largest = std::max(
        largest, (a.bodies[body].positions - b.bodies[body].positions).rowwise().norm().maxCoeff());
  return largest;
}

// Where nothing folds there is one minimum, whatever the way to it.
TEST(PaperClosing, ItEndsInTheMinimumOfAClosedStart) {
  const Eigen::RowVector3d apart(1.5, -1, 2);
  const BodyProblem problem = two_tubes(apart);
  PaperOptions options;
  options.seam_tolerance = 1e-6;
  const SurfaceSolution closed = solve_paper(problem, options);
  ASSERT_EQ(closed.status, Status::converged);
  for (const double step : {0.1, 0.5}) {
    const PaperWay way = way_of(problem, apart, step);
    const SurfaceSolution on_way = PaperSolver(options).solve(problem, &way);
    EXPECT_EQ(on_way.status, Status::converged);
    EXPECT_LT(largest_difference(on_way, closed), 1e-6 * radius);
    EXPECT_LT(on_way.largest_seam_gap, 1e-3 * radius);
    ASSERT_EQ(on_way.notes.size(), 1U);
    EXPECT_EQ(on_way.notes[0], step == 0.5 ? "the seam was brought together along a way of 2 "
                                             "steps, as the vessel folds"
                                           : "the seam was brought together along a way of 10 "
                                             "steps, as the vessel folds");
  }
}

TEST(PaperClosing, TheUnitDoesNotMatter) {
  const Eigen::RowVector3d apart(1.5, -1, 2);
  const BodyProblem mm = two_tubes(apart), m = two_tubes(apart, 1e-3);
  const PaperWay in_mm = way_of(mm, apart, 0.25), in_m = way_of(m, 1e-3 * apart, 0.25);
  const SurfaceSolution one = PaperSolver().solve(mm, &in_mm), two = PaperSolver().solve(m, &in_m);
  ASSERT_EQ(two.status, Status::converged);
  EXPECT_EQ(one.outer_iterations, two.outer_iterations);
  EXPECT_LT((two.bodies[1].positions * 1e3 - one.bodies[1].positions).rowwise().norm().maxCoeff(),
            1e-6 * radius);
}

// A tube whose rod is bent so sharply that its sections pass through each other.
struct Folding {
  BodyProblem problem;
  PaperWay way;
  Folding() {
    constexpr double angle = 2 * pi / 3, height = 36;
    SurfaceBody body = body_of("vein", Eigen::RowVector3d::Zero(), 1);
    body.rest = tube(radius, height, around, 20);
    body.fixed.assign(static_cast<size_t>(body.rest.points.rows()), 0);
    fix_ring(body, 0);
    fix_ring(body, around * 20);
    const auto at = [rest = body.rest.points](double t) {
      // The curvature is in the middle; the rest is straight legs.
      Carried c{Points(rest.rows(), 3), {}};
      for (Eigen::Index i = 0; i < rest.rows(); ++i) {
        constexpr double leg = 15, arc = height - 2 * leg;
        const double z = rest(i, 2), turn = t * angle;
        const double share = std::clamp((z - leg) / arc, 0.0, 1.0), here = turn * share;
        const double r = arc / turn;
        Vec3 center(r * (1 - std::cos(here)), 0, std::min(z, leg) + r * std::sin(here));
        center += std::max(0.0, z - leg - arc) * Vec3(std::sin(here), 0, std::cos(here));
        const Mat3 rotation = Eigen::AngleAxisd(here, Vec3::UnitY()).matrix();
        c.points.row(i) = (center + rotation * Vec3(rest(i, 0), rest(i, 1), 0)).transpose();
        c.rotations.push_back(rotation);
      }
      return c;
    };
    const Carried end = at(1);
    body.carried = end.points;
    body.rotations = end.rotations;
    problem.bodies = {body};
    way.carried = [at](double t) {
      const Carried c = at(t);
      return std::vector<CarriedBody>{{c.points, c.rotations, {}}};
    };
    way.seam.offsets = [](double) { return std::vector<Vec3>(); };
    way.seam.step = 0.05;
  }
  double depth(const SurfaceSolution& solution) const {
    double deepest = 0;
    for (const Crossing& found :
         crossings({{&problem.bodies[0].rest, &solution.bodies[0].positions, radius}}, {}))
      deepest = std::max(deepest, found.depth);
    return deepest;
  }
};

TEST(PaperClosing, AWallThatFoldsStaysOutOfItself) {
  Folding folding;
  const SurfaceSolution closed = solve_paper(folding.problem);
  EXPECT_GT(folding.depth(closed), 1);
  folding.problem.contacts = {{0, 0}};
  PaperOptions options;
  options.hold_after = 6;
  options.contact_stiffness = 10;
  const SurfaceSolution on_way = PaperSolver(options).solve(folding.problem, &folding.way);
  EXPECT_EQ(on_way.status, Status::converged) << (on_way.notes.empty() ? "" : on_way.notes.back());
  EXPECT_EQ(folding.depth(on_way), 0);
  const ContactSolution& own = on_way.contacts[0];
  EXPECT_TRUE(own.within_reach);
  EXPECT_EQ(own.largest_pressure, on_way.bodies[0].pressure.maxCoeff());
  EXPECT_GT(own.largest_pressure, 0);
  EXPECT_GT(own.area, 0);
  EXPECT_GT(own.smallest_gap, 0) << "of the faces";
  EXPECT_LT(own.smallest_gap, 0.06 * mean_edge_length(folding.problem.bodies[0].rest));
}

TEST(PaperClosing, StoppedOnTheWayItSaysSo) {
  Folding folding;
  folding.problem.contacts = {{0, 0}};
  PaperOptions options;
  int asked = 0;
  options.stop = [&] { return ++asked > 40; };
  const SurfaceSolution stopped = PaperSolver(options).solve(folding.problem, &folding.way);
  EXPECT_EQ(stopped.status, Status::interrupted);
  EXPECT_TRUE(stopped.bodies[0].positions.allFinite());
  EXPECT_TRUE(std::isfinite(stopped.residual));
}

}  // namespace
}  // namespace vasorod
