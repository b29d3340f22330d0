#include <gtest/gtest.h>

#include "paper/paper_energy.h"
#include "paper/paper_tubes.h"

namespace vasorod {
namespace {

using namespace testing;

// Two small joined tubes with contacts: pressing, open, and against a fixed plane.
PaperSystem two_tubes() {
  PaperSystem system;
  const TriangleSurface t = tube(1, 2, 6, 3);
  const int n = static_cast<int>(t.points.rows());
  const std::vector<char> none(static_cast<size_t>(n), 0);
  append_body(system, t, t.points, random_rotations(n, 1), {0.3, 0.5, 0.9}, none);
  Points shifted = t.points.rowwise() + Eigen::RowVector3d(1.8, 0.1, 0.2);
  append_body(system, {shifted, t.triangles}, shifted, random_rotations(n, 2), {0.2, 0.8, 0.4},
              none);
  system.k_j = 3;
  system.joins = {{0, n, Vec3(0.1, 0.2, -0.3)}, {2, n + 3, Vec3::Zero()}};
  system.contacts = {
      {5, {n + 1, n + 2, n + 8}, Vec3(0.2, 0.3, 0.5), Vec3(0.6, 0, 0.8), 0.9, 0.7, 2, 1},
      {7, {n + 4, n + 5, n + 9}, Vec3(0.2, 0.3, 0.5), Vec3(0, 1, 0), -90, 0.7, 2, 1},
      {9, {-1, -1, -1}, Vec3::Zero(), Vec3(0, 0, 1), 2.5, 0.7, 2, 0}};
  return system;
}

Points start(const PaperSystem& system) {
  return system.carried + random_points(system.vertex_count(), 3, 0.15);
}

Points gradient_of(const PaperSystem& system, const Points& p) {
  PaperGradient terms;
  paper_energy_gradient(system, p, terms);
  return terms.sum();
}

Eigen::MatrixXd full(const Eigen::SparseMatrix<double>& lower) {
  return Eigen::MatrixXd(Eigen::MatrixXd(lower).selfadjointView<Eigen::Lower>());
}

Eigen::SparseMatrix<double> both_triangles(const Eigen::SparseMatrix<double>& lower) {
  return lower.selfadjointView<Eigen::Lower>();
}

TEST(PaperEnergy, GradientAndHessianMatchDifferences) {
  const PaperSystem system = two_tubes();
  const Points p = start(system);
  EXPECT_NEAR(contact_pressure(system.contacts[1], p), 0, 0);
  EXPECT_GT(contact_pressure(system.contacts[0], p), 0);
  EXPECT_GT(contact_pressure(system.contacts[2], p), 0);
  const auto value = [&](const Points& at) { return paper_energy(system, at); };
  const auto gradient = [&](const Points& at) { return gradient_of(system, at); };
  EXPECT_LT(gradient_error(value, p, gradient(p)), 1e-8);
  EXPECT_LT(hessian_error(gradient, p, full(paper_energy_hessian(system, p))), 1e-7);
}

TEST(PaperEnergy, ValueIsTheSumOfTheTerms) {
  const PaperSystem system = two_tubes();
  PaperGradient gradient;
  const Points p = start(system);
  EXPECT_NEAR(paper_energy(system, p), paper_energy_gradient(system, p, gradient).total(), 1e-12);
}

// A thousand lengths away from the origin a displacement of 1e-13 is the last digit of a
// coordinate.
TEST(PaperEnergy, GradientFollowsDisplacementsBelowTheRoundingOfThePoints) {
  PaperSystem system = two_tubes();
  system.joins.clear();
  system.contacts.clear();
  system.carried.array() += 1000;
  const Eigen::MatrixXd hessian = full(paper_energy_hessian(system, system.carried));
  const auto gradient = [&](const Points& u) {
    PaperGradient terms;
    paper_energy_gradient_at(system, u, terms);
    return terms.sum();
  };
  const Points u = random_points(system.vertex_count(), 3, 1e-13), none = Points::Zero(u.rows(), 3),
               change = gradient(u) - gradient(none);
  const Eigen::VectorXd expected = hessian * Eigen::Map<const Eigen::VectorXd>(u.data(), u.size());
  EXPECT_LT((Eigen::Map<const Eigen::VectorXd>(change.data(), change.size()) - expected).norm(),
            0.01 * expected.norm());
}

TEST(PaperEnergy, BoundLiesAboveTheHessianAndIsTheBlendedOne) {
  const PaperSystem system = two_tubes();
  const Points p = start(system);
  const Eigen::MatrixXd bound = for_xyz(both_triangles(paper_energy_bound(system, p)));
  const Eigen::MatrixXd rest = bound - full(paper_energy_hessian(system, p));
  EXPECT_GT(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(rest).eigenvalues().minCoeff(), -1e-10);
  PaperSystem apart = system;
  apart.contacts.clear();
  EXPECT_TRUE(for_xyz(both_triangles(paper_energy_bound(apart, p)))
                  .isApprox(full(paper_energy_hessian(apart, p, 1)), 1e-12));
}

TEST(PaperEnergy, FixedVerticesStandAloneInTheMatrices) {
  PaperSystem system = two_tubes();
  system.fixed[5] = system.fixed[40] = 1;
  const Points p = start(system);
  const Eigen::MatrixXd bound(both_triangles(paper_energy_bound(system, p))),
      hessian = full(paper_energy_hessian(system, p));
  for (const int i : {5, 40}) {
    EXPECT_GT(bound(i, i), 0);
    EXPECT_NEAR(bound.col(i).cwiseAbs().sum(), bound(i, i), 1e-14);
    for (int c = 3 * i; c < 3 * i + 3; ++c) {
      EXPECT_GT(hessian(c, c), 0);
      EXPECT_NEAR(hessian.col(c).cwiseAbs().sum(), hessian(c, c), 1e-14);
    }
  }
}

// A rigid motion of carried points, rotations, multipliers, normals and positions changes no energy
// and rotates every force.
TEST(PaperEnergy, TurnsWithTheSpace) {
  PaperSystem system = two_tubes();
  const Points p = start(system);
  const Mat3 r = random_rotations(1, 9).front();
  const Eigen::RowVector3d shift(4, -7, 2);
  PaperSystem moved = system;
  moved.carried = (system.carried * r.transpose()).rowwise() + shift;
  moved.carried_laplacian = system.carried_laplacian * r.transpose();
  moved.carried_misfit = system.carried_misfit * r.transpose();
  for (Join& join : moved.joins) join.multiplier = r * join.multiplier;
  for (ContactPoint& c : moved.contacts) {
    c.normal = r * c.normal;
    if (c.master[0] < 0) c.slack += c.normal.dot(shift);
  }
  const Points q = (p * r.transpose()).rowwise() + shift;
  EXPECT_NEAR(paper_energy(moved, q) / paper_energy(system, p), 1, 1e-12);
  EXPECT_TRUE(gradient_of(moved, q).isApprox(gradient_of(system, p) * r.transpose(), 1e-11));
}

}  // namespace
}  // namespace vasorod
