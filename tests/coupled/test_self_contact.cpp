#include <cmath>
#include <gtest/gtest.h>

#include "accuracy/collapsed_ring.h"
#include "coupled/held_tubes.h"

namespace vasorod {
namespace {

using namespace testing;
using bench::CollapsedRing, bench::published_area;

// Flaherty, Keller and Rubinow 1972: areas over that of the circle. Opposite walls touch in a point
// from q = 5.247 on, along a line from 10.336 on. 96 points around: 2 % (1.1 % at most was
// measured, and half of it with 128).
TEST(SelfContact, ACollapsedRingIsInContactWithItselfAsPublished) {
  const CollapsedRing ring;
  for (const auto& [q, touches] : {std::pair{4., false}, {5.24689, true}, {10.3360, true}}) {
    const CoupledSolution solution = ring.at(q);
    EXPECT_EQ(solution.status, Status::buckled) << solution.brief_report();
    EXPECT_NEAR(ring.area_ratio(solution), published_area(q), 0.02 * published_area(q)) << q;
    const ContactSolution& contact = solution.surface.contacts.at(0);
    EXPECT_EQ(contact.within_reach, touches) << q;
    EXPECT_EQ(contact.area > 0, touches) << q;
    EXPECT_EQ(contact.force, Vec3::Zero());
    // What one wall feels the other gives: nothing is left over.
    EXPECT_LT(solution.surface.bodies[0].residual, 1e-6);
  }
}

// A barrier in place of contacts keeps the walls apart by up to a tenth of an edge, .0065 R.
TEST(SelfContact, BehindABarrierACollapsedRingHasTheSameShape) {
  const CollapsedRing ring;
  for (const auto& [q, touches] : {std::pair{4., false}, {7., true}}) {
    const CoupledSolution contacts = ring.at(q), solution = ring.at(q, true);
    EXPECT_EQ(solution.status, Status::buckled) << solution.brief_report();
    const double area = ring.area_ratio(contacts);
    EXPECT_NEAR(ring.area_ratio(solution), area, 0.02 * area) << q;
    const ContactSolution& contact = solution.surface.contacts.at(0);
    EXPECT_EQ(contact.within_reach, touches) << q;
    // The walls lie above each other along y where they are nearest.
    const Points section = ring.middle(solution);
    const double apart = section(ring.around / 4, 1) - section(3 * ring.around / 4, 1);
    if (touches) {
      EXPECT_NEAR(contact.smallest_gap, apart, 0.01) << q;
    }
    EXPECT_LT(solution.surface.bodies[0].residual, 1e-6);
    EXPECT_EQ(solution.notes.size(), contacts.notes.size() + (touches ? 1 : 0));
  }
}

// Along a path whose steps carry the end by several edges, twice: the second solve starts anew.
TEST(SelfContact, ABarrierThatNothingMeetsChangesNothing) {
  const HeldTube tube(60, 6, 0.6, 24, 36);
  Vec6 change = Vec6::Zero();
  change[4] = 0.6 * 0.471 * 0.6 / (36 * std::sqrt(0.91));
  const auto problem = [&](bool guarded) {
    CoupledProblem one = bent(tube, change, tube.start(), tube.end());
    one.surfaces.contacts = self_contacts(one.surfaces.bodies);
    one.guarded = guarded;
    return one;
  };
  CoupledOptions options;
  options.times = {0.4, 0.9, 1};
  const CoupledSolution free = CoupledSolver(problem(false), options).solve();
  CoupledSolver solver(problem(true), options);
  for (int solve = 0; solve < 2; ++solve) {
    const CoupledSolution guarded = solver.solve();
    EXPECT_EQ(guarded.status, Status::converged) << guarded.brief_report();
    EXPECT_LT((guarded.surface.bodies[0].positions - free.surface.bodies[0].positions)
                  .cwiseAbs()
                  .maxCoeff(),
              1e-6 * 6);
    EXPECT_FALSE(guarded.surface.contacts.at(0).within_reach);
    EXPECT_EQ(guarded.notes, free.notes);
  }
}

// A single step from the round ring to four collapse pressures carries walls far: they still end
// on their own sides.
TEST(SelfContact, AStartFarAwayDoesNotCarryWallsThroughEachOther) {
  const CollapsedRing ring;
  CoupledOptions options;
  options.times = {0.25, 1};
  const CoupledSolution solution = CoupledSolver(ring.under(12), options).solve();
  EXPECT_EQ(solution.status, Status::buckled) << solution.brief_report();
  const Points section = ring.middle(solution);
  const int quarter = ring.around / 4;
  EXPECT_GT(section(quarter, 1), section(3 * quarter, 1));
  EXPECT_GT(solution.surface.contacts.at(0).area, 0);
}

// Without the pair the walls pass through each other.
TEST(SelfContact, WithoutItTheWallsPassThroughEachOther) {
  const CollapsedRing ring;
  CoupledProblem problem = ring.under(8);
  problem.surfaces.contacts.clear();
  CoupledOptions options;
  options.times = {0.35, 0.4, 0.45, 0.5, 0.6, 0.7, 0.8, 0.9, 1};
  const CoupledSolution solution = CoupledSolver(std::move(problem), options).solve();
  const Points section = ring.middle(solution);
  const int quarter = ring.around / 4;
  EXPECT_LT(section(quarter, 1), section(3 * quarter, 1));
}

}  // namespace
}  // namespace vasorod
