#include <gtest/gtest.h>

#include "data/index.h"
#include "rod/energy.h"
#include "rod/rods.h"
#include "rod/scan_stress.h"

namespace vasorod {
namespace {

// A bent tree of three branches whose elements press and are stretched, unevenly.
struct Tree {
  RodTree tree;
  RodConditions held;
  Tree() {
    const Vec6 stiffness = isotropic(40, 100, 30, 20);
    tree = chain(frame({1, 2, 3}, {0, 1, 0}, {1, 0, 0}), 8, {0.1, 0.05, 0}, 12, stiffness);
    const Pose fork = tree.rest[12];
    const int a = append(tree, fork, 12, 5, {0, 0, 0.1}, 7, stiffness),
              b = append(tree, fork, 12, 6, {0.2, 0, 0}, 8, stiffness);
    held.supports = {clamp(0), clamp(a), clamp(b)};
    held.supports[1].motion.move = {1, 0, 0};  // after the scan
    double size = 1;
    for (RodElement& element : tree.elements) {
      size = 1.7 - size * 0.6;
      element.lumen = vec6(0, 0, 2 * size, 0, 0, 0);
    }
  }
};

// The out-of-balance of the nodes that nothing holds.
double unbalance(const RodTree& tree, const std::vector<Vec6>& stress,
                 const std::vector<int>& held) {
  std::vector<Vec6> sum(tree.rest.size(), Vec6::Zero());
  for (std::size_t e = 0; e < tree.elements.size(); ++e) {
    RodElement element = tree.elements[e];
    const auto a = index(element.first), b = index(element.second);
    element.natural_strain = element_strain(element, tree.rest[a], tree.rest[b]);
    element.lumen = -stress[e];  // all of the stress
    const Vec12 g = element_energy_gradient(element, tree.rest[a], tree.rest[b]);
    sum[a] += g.head<6>();
    sum[b] += g.tail<6>();
  }
  for (const int node : held) sum[index(node)].setZero();
  double worst = 0;
  for (const Vec6& s : sum) worst = std::max(worst, s.norm());
  return worst;
}

TEST(ScanStress, BalancesInTheShapeAsSeen) {
  const Tree t;
  std::vector<int> held;
  for (const RodSupport& s : t.held.supports) held.push_back(s.node);
  const std::vector<Vec6> stress = scan_stress(t.tree, t.held);
  EXPECT_LT(unbalance(t.tree, stress, held), 1e-13);
  // The pressure alone does not.
  std::vector<Vec6> pressure;
  for (const RodElement& e : t.tree.elements) pressure.push_back(-e.lumen);
  EXPECT_GT(unbalance(t.tree, pressure, held), 0.1);
}

// Natural strains from that stress leave the rod where it is, to round-off.
TEST(ScanStress, ARodWithItStaysAsItIs) {
  Tree t;
  const std::vector<Vec6> stress = scan_stress(t.tree, t.held);
  for (std::size_t e = 0; e < stress.size(); ++e) {
    RodElement& element = t.tree.elements[e];
    element.natural_strain -=
        (stress[e] + element.lumen).cwiseQuotient(element.stiffness.diagonal());
  }
  t.held.supports[1].motion = {};
  const RodSolution solution = solve_rod(t.tree, t.held);
  EXPECT_EQ(solution.summary.status, Status::converged);
  double moved = 0;
  for (std::size_t n = 0; n < solution.poses.size(); ++n)
    moved = std::max(moved, (solution.poses[n].position - t.tree.rest[n].position).norm());
  EXPECT_LT(moved, 1e-12);
  for (std::size_t e = 0; e < stress.size(); ++e)
    EXPECT_LT((solution.stress[e] - stress[e]).norm(), 1e-12);
}

// A straight held rod keeps all of it: nothing moves, and the stress is the thrust.
TEST(ScanStress, AStraightHeldRodIsUnderItsThrust) {
  RodTree tree = chain(Pose{}, 10, Vec3::Zero(), 8, isotropic(40, 100, 30, 20));
  for (RodElement& e : tree.elements) e.lumen = vec6(0, 0, 3, 0, 0, 0);
  RodConditions held;
  held.supports = {clamp(0), clamp(8)};
  for (const Vec6& s : scan_stress(tree, held))
    EXPECT_LT((s - vec6(0, 0, -3, 0, 0, 0)).norm(), 1e-13);
  held.supports.pop_back();  // an end that moves leaves no stress: its lid pulls
  for (const Vec6& s : scan_stress(tree, held)) EXPECT_LT(s.norm(), 1e-13);
}

}  // namespace
}  // namespace vasorod
