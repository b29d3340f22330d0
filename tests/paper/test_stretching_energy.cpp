#include <gtest/gtest.h>

#include "paper/paper_tubes.h"
#include "paper/stretching_energy.h"

namespace vasorod {
namespace {

using namespace testing;

std::vector<Spring> springs_of(const TriangleSurface& t) {
  std::vector<Spring> springs;
  for (const Edge& e : edges_of(t.triangles))
    springs.push_back({e.a, e.b, (t.points.row(e.a) - t.points.row(e.b)).norm()});
  return springs;
}

Points gradient_of(double k, const std::vector<Spring>& springs, const Points& p) {
  Points g = Points::Zero(p.rows(), 3);
  stretching_energy_gradient(k, springs, Points::Zero(p.rows(), 3), p, g);
  return g;
}

TEST(StretchingEnergy, IsTheSumAsPrinted) {
  Points p(2, 3);
  p << 0, 0, 0, 3, 4, 0;
  EXPECT_DOUBLE_EQ(stretching_energy(2, {{0, 1, 4.5}}, p), 2 * 0.25);
}

TEST(StretchingEnergy, GradientAndHessianMatchDifferences) {
  const TriangleSurface t = tube(1, 2, 6, 3);
  const int n = static_cast<int>(t.points.rows());
  const auto springs = springs_of(t);
  const Points p = t.points + random_points(n, 7, 0.2);
  EXPECT_LT(gradient_error([&](const Points& at) { return stretching_energy(0.7, springs, at); }, p,
                           gradient_of(0.7, springs, p)),
            1e-8);
  std::vector<Eigen::Triplet<double>> entries;
  stretching_energy_hessian(0.7, springs, p, entries);
  Eigen::SparseMatrix<double> hessian(3 * n, 3 * n);
  hessian.setFromTriplets(entries.begin(), entries.end());
  EXPECT_LT(
      hessian_error([&](const Points& at) { return gradient_of(0.7, springs, at); }, p, hessian),
      1e-7);
}

TEST(StretchingEnergy, BoundMinusHessianIsPositive) {
  const TriangleSurface t = tube(1, 2, 6, 3);
  const int n = static_cast<int>(t.points.rows());
  const auto springs = springs_of(t);
  std::vector<Eigen::Triplet<double>> entries;
  stretching_energy_hessian(1, springs, t.points + random_points(n, 8, 0.4), entries);
  Eigen::SparseMatrix<double> hessian(3 * n, 3 * n);
  hessian.setFromTriplets(entries.begin(), entries.end());
  const Eigen::MatrixXd rest =
      for_xyz(stretching_energy_bound(1, springs, n)) - Eigen::MatrixXd(hessian);
  EXPECT_GT(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(rest).eigenvalues().minCoeff(), -1e-10);
}

TEST(StretchingEnergy, RigidMotionsCostNothing) {
  const TriangleSurface t = tube(1, 2, 12, 8);
  const Mat3 r = random_rotations(1, 9).front();
  const Points moved = (t.points * r.transpose()).rowwise() + Eigen::RowVector3d(3, -2, 5);
  EXPECT_LT(stretching_energy(1, springs_of(t), moved), 1e-26);
}

TEST(StretchingEnergy, AnEdgeOfLengthZeroGivesNoNaN) {
  const Points p = Points::Zero(2, 3);
  EXPECT_TRUE(gradient_of(1, {{0, 1, 1.0}}, p).isZero());
  EXPECT_TRUE(spring_hessian(1, Vec3::Zero(), 1).allFinite());
}

}  // namespace
}  // namespace vasorod
