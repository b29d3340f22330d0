// States of constant strain are exact with one element of less than half a revolution.
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "rod/newton.h"
#include "rod/rods.h"
#include "rod/strains.h"

namespace vasorod {
namespace {

constexpr double pi = std::numbers::pi;
const Vec6 stiffness = vec6(30, 40, 70, 1.3, 2.1, 0.9);

// One element with natural strain `natural`, clamped at its start. The stress of `strain` acts as a
// dead force and a body moment at its end. If force and moment are parallel as required (see each
// test), this state is exact.
void expect_exact(const Vec6& natural, const Vec6& strain, double length, const Pose& root) {
  RodTree tree = chain(root, length, natural.tail<3>(), 1, stiffness);
  tree.elements[0].natural_strain = natural;
  tree.elements[0].rest_strain = natural;
  tree.rest[1] = root * exp_motion(length * natural);
  const Vec6 stress = stiffness.asDiagonal() * (strain - natural);
  const Pose end = root * exp_motion(length * strain);
  RodConditions conditions;
  conditions.supports = {clamp(0)};
  conditions.loads = {{1, end.rotation * stress.head<3>(), stress.tail<3>(), true}};
  const RodSolution s = solve_rod(tree, conditions);
  EXPECT_TRUE(s.summary.status == Status::converged || s.summary.status == Status::equilibrium_only)
      << s.summary.message;
  EXPECT_LT((s.poses[1].position - end.position).norm(), 1e-10 * length);
  EXPECT_LT((s.poses[1].rotation - end.rotation).norm(), 1e-10);
  EXPECT_LT((element_strains(tree, s.poses)[0] - strain).norm(), 1e-10);
  EXPECT_LT((s.stress[0] - stress).norm(), 1e-9);
  EXPECT_NEAR(s.summary.energy, 0.5 * length * (strain - natural).dot(stress), 1e-10);
}

const Vec6 straight = vec6(0, 0, 1, 0, 0, 0);
const Pose somewhere = exp_motion(vec6(2, -1, 4, 0.3, -0.7, 1.1));

TEST(Patch, Stretch) {
  expect_exact(straight, vec6(0, 0, 1.3, 0, 0, 0), 2, somewhere);
  expect_exact(straight, vec6(0, 0, 0.7, 0, 0, 0), 0.25,
               somewhere);  // below the column's critical load
}

TEST(Patch, Shear) {  // a force along v needs no moment: v x n = 0 where EA (v3 - 1) / v3 = GA
  const double v3 = stiffness[2] / (stiffness[2] - stiffness[0]);
  expect_exact(straight, vec6(0.4, 0, v3, 0, 0, 0), 2, somewhere);
}

TEST(Patch, Twist) {
  expect_exact(straight, vec6(0, 0, 1, 0, 0, 1.4), 2, somewhere);
}

TEST(Patch, Bend) {
  expect_exact(straight, vec6(0, 0, 1, 1.2, 0, 0), 2, somewhere);
  expect_exact(straight, vec6(0, 0, 1, 0, -1.5, 0), 2, somewhere);
}

TEST(Patch, Helix) {  // moments alone: u x m = 0 requires m along u; this fixes the natural strain
  const Vec3 u(0, 0.9, 0.6), m = 0.5 * u;
  const Vec6 strain = vec6(0, 0, 1, u[0], u[1], u[2]);
  Vec6 natural = strain;
  natural.tail<3>() -= m.cwiseQuotient(stiffness.tail<3>());
  expect_exact(natural, strain, 2.5, somewhere);
}

// Love's spring: a helix under an axial force stays a helix. n along u, and u x m = n x v gives
// m = a u + (n x v) x u / u.u; natural strains follow from the stresses.
TEST(Patch, HelicalSpringUnderAnAxialForce) {
  const Vec3 u(0, 0.9, 0.4), v(0.05, 0.1, 1.1);
  for (const double force : {0.8, -0.5}) {
    const Vec3 n = force * u.normalized(), m = 0.3 * u + n.cross(v).cross(u) / u.squaredNorm();
    Vec6 strain, natural;
    strain << v, u;
    natural << v - n.cwiseQuotient(stiffness.head<3>()), u - m.cwiseQuotient(stiffness.tail<3>());
    expect_exact(natural, strain, 2.5, somewhere);
    // and with many elements over five revolutions
    const int elements = 24;
    const double length = 5 * 2 * pi / u.norm();
    RodTree tree = chain(somewhere, length, natural.tail<3>(), elements, stiffness);
    tree.rest[0] = somewhere;
    for (std::size_t e = 0; e < tree.elements.size(); ++e) {
      tree.elements[e].natural_strain = tree.elements[e].rest_strain = natural;
      tree.rest[e + 1] = tree.rest[e] * exp_motion(tree.elements[e].length * natural);
    }
    const Pose end = somewhere * exp_motion(length * strain);
    RodConditions conditions;
    conditions.supports = {clamp(0), clamp_at(tree, elements, end)};
    std::vector<Pose> poses;
    for (int i = 0; i <= elements; ++i)
      poses.push_back(somewhere * exp_motion(length * i / elements * strain));
    RodOptions options;
    options.leave_saddle = false;
    const RodSolution s = solve_rod(tree, conditions, options, &poses);
    for (const Vec6& e : element_strains(tree, s.poses)) EXPECT_LT((e - strain).norm(), 1e-10);
    EXPECT_LT((s.reactions[1].force - end.rotation * n).norm(), 1e-9);
    EXPECT_LT((s.reactions[1].moment - end.rotation * m).norm(), 1e-9);
  }
}

}  // namespace
}  // namespace vasorod
