#include <gtest/gtest.h>

#include "bodies/contact_energy.h"
#include "paper/paper_tubes.h"

namespace vasorod {
namespace {

using namespace testing;

// Pressing, open with a multiplier, against a body at rest, and two that stick: pressing and open;
// a vertex at rest, which sticks and presses.
std::vector<ContactPoint> contacts() {
  return {
      {0, {3, 4, 5}, Vec3(0.2, 0.3, 0.5), Vec3(0.6, 0, 0.8), 1.5, 0.7, 2, 1},
      {1, {4, 5, 6}, Vec3(0.1, 0.8, 0.1), Vec3(0, 1, 0), -9, 0.4, 2, 1},
      {2, {-1, -1, -1}, Vec3::Zero(), Vec3(0, 0, 1), 2.5, 0.9, 3, 0},
      {3, {0, 1, 2}, Vec3(0.4, 0.4, 0.2), Vec3(0, 0.8, 0.6), 3, 0.6, 2, 1, 5, Vec3(0.1, 0, 0.3)},
      {6, {0, 2, 5}, Vec3(0.3, 0.3, 0.4), Vec3(1, 0, 0), -9, 0.6, 2, 0, 1.5, Vec3(0, 0.2, 0)},
      {-1, {2, 3, 6}, Vec3(0.5, 0.1, 0.4), Vec3(0, 0.6, 0.8), 2, 0.8, 3, 1, 2, Vec3(0, 0.1, 0.4)}};
}

Points gradient_at(const Points& p) {
  Points g = Points::Zero(p.rows(), 3);
  contact_energy_gradient(contacts(), p, g);
  return g;
}

TEST(ContactEnergy, GradientAndHessianMatchDifferences) {
  const Points p = random_points(7, 1);
  EXPECT_LT(gradient_error([](const Points& at) { return contact_energy(contacts(), at); }, p,
                           gradient_at(p)),
            1e-8);
  std::vector<Eigen::Triplet<double>> entries;
  contact_energy_hessian(contacts(), p, entries);
  Eigen::SparseMatrix<double> hessian(21, 21);
  hessian.setFromTriplets(entries.begin(), entries.end());
  EXPECT_LT(hessian_error(gradient_at, p, hessian), 1e-8);
  const Eigen::MatrixXd rest =
      for_xyz(contact_energy_bound(contacts(), p)) - Eigen::MatrixXd(hessian);
  EXPECT_GT(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(rest).eigenvalues().minCoeff(), -1e-12);
}

TEST(ContactEnergy, PressureIsTheMultiplierAtAClosedGapAndZeroWhenApart) {
  ContactPoint c{0, {-1, -1, -1}, Vec3::Zero(), Vec3(0, 0, 1), 2, 0.5, 10, 3};
  Points p(1, 3);
  p << 7, 8, 2;
  EXPECT_EQ(contact_pressure(c, p), 3);
  p(0, 2) = 2.5;
  EXPECT_EQ(contact_pressure(c, p), 0);
  p(0, 2) = 1.9;
  EXPECT_NEAR(contact_pressure(c, p), 4, 1e-12);
}

TEST(ContactEnergy, StickingResistsSlidingOverThePlaneOnly) {
  ContactPoint c{0, {1, 2, 3}, Vec3(0.5, 0.25, 0.25), Vec3(0, 0, 1), -9, 0.5, 10, 0, 4};
  Points p(4, 3);
  p << 0.3, -0.4, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0;
  EXPECT_EQ(contact_slip(c, p), Vec3(0.3, -0.4, 0));
  EXPECT_DOUBLE_EQ(contact_energy({c}, p), 0.5 * 4 / 2 * 0.25);
  p(0, 2) = 7;  // away from the plane
  EXPECT_DOUBLE_EQ(contact_energy({c}, p), 0.5 * 4 / 2 * 0.25);
  p.rowwise() += Vec3(1, 2, 3).transpose();  // both together
  EXPECT_NEAR(contact_energy({c}, p), 0.5 * 4 / 2 * 0.25, 1e-15);
  c.held = Vec3(0.3, -0.4, 1);
  EXPECT_NEAR(contact_energy({c}, p), 0, 1e-15);
}

// The same as one that may move and does not.
TEST(ContactEnergy, AVertexAtRestIsInTheSlackAndWhereItIsHeld) {
  const ContactPoint moving = contacts()[3];
  const Points p = random_points(7, 3);
  ContactPoint fixed = moving;
  fixed.slave = -1;
  fixed.slack -= fixed.normal.dot(p.row(moving.slave));
  fixed.held -= p.row(moving.slave);
  EXPECT_NEAR(contact_gap(fixed, p), contact_gap(moving, p), 1e-14);
  EXPECT_LT((contact_slip(fixed, p) - contact_slip(moving, p)).norm(), 1e-14);
  EXPECT_NEAR(contact_energy({fixed}, p), contact_energy({moving}, p), 1e-13);
  Points of_fixed = Points::Zero(7, 3), of_moving = Points::Zero(7, 3);
  contact_energy_gradient({fixed}, p, of_fixed);
  contact_energy_gradient({moving}, p, of_moving);
  of_moving.row(moving.slave).setZero();  // what it pushes with is the fixed body's to bear
  EXPECT_LT((of_fixed - of_moving).norm(), 1e-13);
  EXPECT_GT(of_fixed.norm(), 0.1);
}

TEST(ContactEnergy, ForcesOnBothSidesAddUpToZero) {
  const std::vector<ContactPoint> pair{contacts()[0]};
  const Points p = random_points(7, 2);
  Points g = Points::Zero(7, 3);
  contact_energy_gradient(pair, p, g);
  ASSERT_GT(contact_pressure(pair[0], p), 0);
  EXPECT_LT(g.colwise().sum().norm(), 1e-15);
  EXPECT_NEAR(g.row(0).norm(), pair[0].area * contact_pressure(pair[0], p), 1e-14);
}

}  // namespace
}  // namespace vasorod
