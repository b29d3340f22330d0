// Two pieces of a tube tied at a section are the whole tube, also if a gap between them is closed.
#include <cmath>
#include <gtest/gtest.h>

#include "reference_fem/model_pair.h"
#include "reference_fem/stepper.h"
#include "reference_fem/tube_ends.h"

namespace vasorod::fem {
namespace {

constexpr std::array<bool, 6> all{true, true, true, true, true, true};

Shell piece(const TubeShape& tube) {
  return {make_surface({{6, 3, 1}, true, 3},
                       [=](const Vec3& p) {
                         return tube.point({p[0], p[1], 0.5});
                       }),
          MaterialLaw(LawKind::neo_hookean, Moduli::isotropic(1, 0.3)), tube_body(tube), 3};
}

TubeShape tube_of(double length, double from) {
  TubeShape tube{length, 2, 0.4, 2, 0.4, 0, {}};
  tube.placement.position = Vec3(0, 0, from);
  return tube;
}

struct Outcome {
  StepperSummary summary;
  Vec6 start = Vec6::Zero(), end = Vec6::Zero();
};

Outcome solve(const Model& model, Supports supports) {
  const System system(model, std::move(supports));
  State state;
  System::Assembly assembly;
  Outcome out;
  out.summary = follow_path(system, state, assembly);
  out.start = assembly.section_force[0];
  out.end = assembly.section_force[1];
  return out;
}

/// Two pieces of length 3 and 4 with a gap between them that the ties close, both ends held; the
/// end moves by `move`.
Outcome tied(double gap, const Vec3& move, const Vec3& rotation) {
  const TubeShape low = tube_of(3, 0), high = tube_of(4, 3 + gap);
  const Shell first = piece(low), second = piece(high);
  const ModelPair pair(first, second);
  Supports supports;
  supports.sections = {end_section(first, low, 0, false), end_section(second, high, 1, false)};
  for (Member& member : supports.sections[1].members) member.first_dof += first.dof_count();
  for (Section& section : supports.sections) section.fixed = all;
  supports.sections[1].move = move;
  supports.sections[1].rotation = rotation;
  for (const int node : first.mesh().nodes_on(1, 1)) {
    const int other = second.mesh().nearest_node({first.mesh().parameters(node, 0), 0, 0});
    const Vec3 between = first.mesh().nodes.row(node) - second.mesh().nodes.row(other);
    EXPECT_NEAR(between.norm(), gap, 1e-12);
    for (int k = 0; k < 7; ++k)
      supports.ties.push_back(
          {7 * node + k, first.dof_count() + 7 * other + k, k < 3 ? -between[k] : 0});
  }
  return solve(pair, std::move(supports));
}

/// One tube of the cells of both pieces.
Outcome whole(const Vec3& move, const Vec3& rotation) {
  const TubeShape tube = tube_of(7, 0);
  const Shell shell(make_surface({{6, 6, 1}, true, 3},
                                 [=](const Vec3& p) {
                                   const double s = p[1] < 0.5 ? 6 * p[1] : 3 + 8 * (p[1] - 0.5);
                                   return tube.point({p[0], s / 7, 0.5});
                                 }),
                    MaterialLaw(LawKind::neo_hookean, Moduli::isotropic(1, 0.3)), tube_body(tube),
                    3);
  Supports supports;
  supports.sections = {end_section(shell, tube, 0, false), end_section(shell, tube, 1, false)};
  for (Section& section : supports.sections) section.fixed = all;
  supports.sections[1].move = move;
  supports.sections[1].rotation = rotation;
  return solve(shell, std::move(supports));
}

void expect_equal(const Outcome& a, const Outcome& b) {
  EXPECT_EQ(a.summary.status, PathStatus::complete);
  EXPECT_EQ(b.summary.status, PathStatus::complete);
  EXPECT_EQ(a.summary.positive_definite, true);
  EXPECT_GT(b.summary.energy, 0.01);
  EXPECT_NEAR(a.summary.energy / b.summary.energy, 1, 1e-7);
  EXPECT_LT((a.start - b.start).norm(), 1e-6 * b.start.norm());
  EXPECT_LT((a.end - b.end).norm(), 1e-6 * b.end.norm());
}

TEST(ModelPair, TiedPiecesAreTheWholeTube) {
  const Vec3 move(1.2, 0, 0.4), rotation(0, 0.3, 0.2);
  expect_equal(tied(0, move, rotation), whole(move, rotation));
}

// Closing a gap stretches the pieces as moving the end of the whole by the gap does.
TEST(ModelPair, AClosedGapStretchesByItsLength) {
  const double gap = 0.6;
  expect_equal(tied(gap, Vec3::Zero(), Vec3::Zero()), whole({0, 0, gap}, Vec3::Zero()));
  expect_equal(tied(gap, {1, 0, -gap}, {0, 0.2, 0}), whole({1, 0, 0}, {0, 0.2, 0}));
}

}  // namespace
}  // namespace vasorod::fem
