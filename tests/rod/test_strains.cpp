#include <gtest/gtest.h>

#include "rod/energy.h"
#include "rod/rods.h"
#include "rod/strains.h"

namespace vasorod {
namespace {

TEST(Strains, AScrewHasTheStrainItIsMadeOf) {
  const RodTree rod = chain({}, 10, {0.01, 0.02, 0.03}, 4, isotropic(1, 1, 1, 1));
  const Vec6 strain = vec6(0.05, -0.02, 1.1, 0.1, -0.2, 0.15);
  RodPoses poses{rod.rest[0]};
  for (const RodElement& e : rod.elements)
    poses.push_back(poses.back() * exp_motion(e.length * strain));
  for (const Vec6& found : element_strains(rod, poses)) EXPECT_LT((found - strain).norm(), 1e-13);
  for (const Vec6& found : element_strains(rod, rod.rest))
    EXPECT_LT((found - vec6(0, 0, 1, 0.01, 0.02, 0.03)).norm(), 1e-13);
}

TEST(Strains, NodesHaveTheMeanOfTheirElementsByLength) {
  RodTree rod = chain({}, 6, Vec3::Zero(), 3, isotropic(1, 1, 1, 1));
  rod.elements[0].length = 1;
  rod.elements[1].length = 3;
  rod.elements[2].length = 2;
  const std::vector<Vec6> values{Vec6::Constant(4), Vec6::Constant(8), Vec6::Constant(-2)};
  const std::vector<Vec6> nodes = branch_node_values(rod, rod.branches[0], values);
  ASSERT_EQ(nodes.size(), 4u);
  EXPECT_EQ(nodes[0], Vec6::Constant(4));
  EXPECT_EQ(nodes[1], Vec6::Constant(7));  // (1 * 4 + 3 * 8) / 4
  EXPECT_EQ(nodes[2], Vec6::Constant(4));  // (3 * 8 - 2 * 2) / 5
  EXPECT_EQ(nodes[3], Vec6::Constant(-2));
}

// What acts on an element's start is minus the energy's derivative by its first node's motion, with
// the second one held; written in space axes.
TEST(Strains, TheStartsWrenchIsTheEnergysDerivative) {
  RodTree rod = chain(frame({1, 2, 3}, {1, 0, 1}, {0, 1, 0}), 2, {0.1, 0.2, -0.1}, 1,
                      isotropic(5, 9, 2, 1.5));
  rod.elements[0].start = exp_motion(vec6(0.1, 0, 0.2, 0.3, -0.2, 0.1));
  const RodPoses poses{rod.rest[0], rod.rest[1] * exp_motion(vec6(0.2, -0.1, 0.3, 0.4, -0.2, 0.3))};
  const RodElement& e = rod.elements[0];
  const Vec6 stress = element_stress(e, element_strain(e, poses[0], poses[1]));
  const Vec6 wrench = start_wrench(e, poses, stress);
  const double h = 1e-6;
  for (int k = 0; k < 6; ++k) {
    const auto energy = [&](double step) {
      Pose moved = poses[0];  // moved in space, about its own place
      if (k < 3)
        moved.position[k] += step;
      else
        moved.rotation = exp_rotation(step * Vec3::Unit(k - 3)) * moved.rotation;
      return element_energy(e, moved, poses[1]);
    };
    EXPECT_NEAR(wrench[k], (energy(h) - energy(-h)) / (2 * h), 1e-7 * wrench.norm()) << k;
  }
}

}  // namespace
}  // namespace vasorod
