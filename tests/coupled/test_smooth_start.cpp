// Starts from coarser walls, brought near their minimum at the seam and the contacts.
#include <cmath>
#include <gtest/gtest.h>

#include "bodies/late_contacts.h"
#include "coupled/joined_tubes.h"
#include "coupled/smooth_start.h"

namespace vasorod {
namespace {

using namespace testing;

// Too wide beside the seam, as a coarser mesh's minimum is where walls bend within an edge.
void widen_at_seam(CoupledProblem& problem) {
  problem.start->roughness = Roughness::smooth;
  for (size_t b = 0; b < 2; ++b) {
    Points& points = problem.start->bodies[b].points;
    for (Eigen::Index i = 0; i < points.rows(); ++i) {
      const double away = points(i, 2) - joined_length;
      points.row(i).head<2>() *= 1 + 0.2 * std::exp(-away * away / 2);
    }
  }
}

// Both tubes are moved onto a plate beside their seam, by 0.05 more than there is room. They start
// flattened in front of it.
void press(CoupledProblem& problem) {
  const double room = 0.01, way = 0.06;
  const double face = -joined_radius - room;
  add_obstacle(problem, "plate", plate(face - joined_thickness / 2, 8, 18, 26));
  problem.surfaces.contacts = {{0, 3}};
  for (size_t b = 0; b < 2; ++b) {
    problem.vessels[b]->sections.front().motion.move.x() -= way;
    Points& points = problem.start->bodies[b].points;
    points.col(0) = (points.col(0).array() - way).max(face);
  }
  problem.start->bodies.emplace_back();
  problem.start->pressure.emplace_back();
  carry_by_sections(problem);
}

// A stack at the problem's start, as the solver has it before its first minimisation.
struct Started {
  explicit Started(CoupledProblem problem, CoupledOptions options = {})
      : stack(std::move(problem), options), path(stack) {
    put_at_start(stack, path);
    stack.search_contacts();
  }
  double energy() const {
    Eigen::VectorXd g;
    return stack.system->gradient(stack.z, g).total();
  }
  Status bring_near(CoupledMinimiserOptions minimising = {}) {
    minimising.largest_step = 0.3;
    SmoothStart start(stack, path, minimising,
                      [this](const CoupledMinimiserSummary&) { ++minimisations; });
    const Status status = start.bring_near();
    near = start.is_near();
    crossed = start.is_crossed();
    updates = start.updates();
    return status;
  }

  CoupledStack stack;
  CoupledPath path;
  int minimisations = 0, updates = 0;
  bool near = false, crossed = false;
};

CoupledProblem wide(double pull = 0) {
  CoupledProblem problem = joined_tubes(pull);
  widen_at_seam(problem);
  return problem;
}

TEST(SmoothStart, BringsWallsNearTheirMinimum) {
  Started started(wide());
  const int whole = started.stack.system->unknowns();
  const double before = started.energy();  // over the minimum, which is that at rest
  EXPECT_EQ(started.bring_near(), Status::converged);
  EXPECT_TRUE(started.near);
  EXPECT_FALSE(started.crossed);
  EXPECT_FALSE(started.stack.is_narrow());
  EXPECT_EQ(started.stack.system->unknowns(), whole);
  EXPECT_LT(started.energy(), 1e-3 * before);
}

// They are updated at a minimum of all walls.
TEST(SmoothStart, LeavesTheSeamsMultipliersAlone) {
  Started started(wide(6));
  EXPECT_EQ(started.bring_near(), Status::converged);
  EXPECT_GT(started.stack.largest_seam_gap(), 0);
  for (const auto& join : started.stack.system->joins) EXPECT_EQ(join.multiplier.norm(), 0);
}

// The pressures that another update would bring are those that are there.
TEST(SmoothStart, FindsThePressuresOfContacts) {
  CoupledProblem problem = wide();
  press(problem);
  Started started(std::move(problem));
  EXPECT_EQ(started.bring_near(), Status::converged);
  EXPECT_TRUE(started.stack.contacts->pressing());
  EXPECT_LT(started.stack.contacts->refresh(started.stack.scaled).force_change, 0.02);
}

// Contacts of walls that crumple would be found differently each time also in the whole, where that
// costs more. Here they would settle, but by no tolerance.
TEST(SmoothStart, SearchesContactsOfWallsThatCrumpleUntilItIsLate) {
  for (const int hold_after : {0, 3}) {
    CoupledOptions options;
    options.hold_after = hold_after;
    options.pressure_tolerance = 1e-300;
    CoupledProblem problem = wide();
    press(problem);
    Started started(std::move(problem), options);
    EXPECT_EQ(started.bring_near(), Status::converged);
    EXPECT_TRUE(started.near);
    EXPECT_EQ(started.updates, hold_after > 0 ? LateContacts::patience_with_held(hold_after) : 3);
  }
}

TEST(SmoothStart, LeavesThePressuresOfCrossedWallsAlone) {
  CoupledOptions options;
  int asked = 0;
  options.passes_through = [&](const std::vector<Points>& now) {
    ++asked;
    EXPECT_EQ(now.size(), 4u);
    return true;
  };
  CoupledProblem problem = wide();
  press(problem);
  Started started(std::move(problem), options);
  EXPECT_EQ(started.bring_near(), Status::converged);
  EXPECT_EQ(asked, 1);
  EXPECT_TRUE(started.crossed);
  EXPECT_EQ(started.minimisations, 3);
  EXPECT_EQ(started.updates, 0);
  for (const ContactPoint& contact : started.stack.stacked.points) EXPECT_EQ(contact.multiplier, 0);
}

TEST(SmoothStart, IsTheWholeAgainWhereItIsStopped) {
  for (const int at : {0, 1, 2}) {
    Started started(wide(6));
    const int whole = started.stack.system->unknowns();
    CoupledMinimiserOptions stopped;
    stopped.stop = [&](int, double, double) { return started.minimisations == at; };
    EXPECT_EQ(started.bring_near(stopped), Status::interrupted);
    EXPECT_EQ(started.minimisations, at + 1);
    EXPECT_EQ(started.stack.system->unknowns(), whole);
    EXPECT_FALSE(started.near);
  }
}

// The updates in the patch count as the first ones of the whole, which is late at once: it accepts
// what it could not before its own fifth update.
TEST(SmoothStart, ItsUpdatesCountInTheWhole) {
  CoupledOptions options;
  options.hold_after = 2;
  options.pressure_tolerance = 5e-7;
  CoupledProblem problem = wide();
  press(problem);
  CoupledSolver solver(std::move(problem), options);
  const CoupledSolution solution = solver.solve();
  ASSERT_EQ(solution.status, Status::converged);
  const int patience = LateContacts::patience_with_held(options.hold_after);
  const int of_start = 2 + 1 + patience;  // minima of the seam, of all, of the patch
  EXPECT_LE(solution.surface.outer_iterations - of_start, patience);
  ASSERT_FALSE(solution.notes.empty());
  EXPECT_EQ(solution.notes.front().find(LateContacts::note({})), 0u) << solution.notes.front();
}

// A solve from a smooth start begins so, one from a near one does not; both end in one minimum.
TEST(SmoothStart, IsHowASolveBegins) {
  const auto solved = [](Roughness roughness) {
    CoupledProblem problem = joined_tubes();
    problem.start->roughness = roughness;
    CoupledSolver solver(std::move(problem));
    return solver.solve();
  };
  const CoupledSolution near = solved(Roughness::near), smooth = solved(Roughness::smooth);
  ASSERT_EQ(near.status, Status::converged);
  ASSERT_EQ(smooth.status, Status::converged);
  EXPECT_EQ(smooth.surface.outer_iterations, near.surface.outer_iterations + 3);
  for (size_t b = 0; b < 2; ++b)
    EXPECT_LT((smooth.surface.bodies[b].positions - near.surface.bodies[b].positions)
                  .rowwise()
                  .norm()
                  .maxCoeff(),
              1e-6);
}

}  // namespace
}  // namespace vasorod
