#include <gtest/gtest.h>

#include "paper/bending_energy.h"
#include "paper/paper_tubes.h"

namespace vasorod {
namespace {

using namespace testing;

TEST(Umbrella, IsTheMeanOfTheNeighboursMinusTheVertex) {
  Triangles t(2, 3);
  t << 0, 1, 2, 0, 2, 3;
  Points p(4, 3);
  p << 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 2;
  const Points l = Umbrella(edges_of(t), 4).apply(p);
  EXPECT_TRUE(l.row(0).isApprox(Eigen::RowVector3d(2.0 / 3, 2.0 / 3, 2.0 / 3)));
  EXPECT_TRUE(l.row(1).isApprox(Eigen::RowVector3d(0.5 - 1, 0.5, 0)));
}

TEST(Umbrella, MatrixAndTransposeAgreeWithApply) {
  const TriangleSurface t = tube(1, 2, 7, 4);
  const int n = static_cast<int>(t.points.rows());
  const Umbrella umbrella(edges_of(t.triangles), n);
  const Points p = random_points(n, 3);
  EXPECT_TRUE(umbrella.apply(p).isApprox(umbrella.matrix() * p, 1e-14));
  Points back = Points::Zero(n, 3);
  umbrella.add_transpose(p, 2.5, back);
  EXPECT_TRUE(back.isApprox(2.5 * (umbrella.matrix().transpose() * p), 1e-14));
  const Points target = random_points(n, 4);
  const Points misfit = umbrella.matrix() * p - target;
  back.setZero();
  EXPECT_NEAR(umbrella.add_misfit(p, target, 2.5, back) / misfit.squaredNorm(), 1, 1e-14);
  EXPECT_TRUE(back.isApprox(2.5 * (umbrella.matrix().transpose() * misfit), 1e-14));
}

TEST(BendingEnergy, GradientAndHessianMatchDifferences) {
  const TriangleSurface t = tube(1, 2, 6, 3);
  const int n = static_cast<int>(t.points.rows());
  const Umbrella umbrella(edges_of(t.triangles), n);
  const Points carried = carried_laplacian(umbrella, t.points, random_rotations(n, 4));
  const Points p = t.points + random_points(n, 5, 0.2);
  const auto gradient = [&](const Points& at) {
    Points g = Points::Zero(n, 3);
    bending_energy_gradient(0.7, umbrella, at, carried, g);
    return g;
  };
  const auto value = [&](const Points& at) { return bending_energy(0.7, umbrella, at, carried); };
  EXPECT_LT(gradient_error(value, p, gradient(p)), 1e-8);
  EXPECT_LT(hessian_error(gradient, p, for_xyz(bending_energy_hessian(0.7, umbrella))), 1e-8);
  Points g = Points::Zero(n, 3);
  EXPECT_NEAR(bending_energy_gradient(0.7, umbrella, p, carried, g) / value(p), 1, 1e-14);
}

TEST(BendingEnergy, ARigidMotionOfTheRodCostsNothing) {
  const TriangleSurface t = tube(1, 2, 12, 8);
  const int n = static_cast<int>(t.points.rows());
  const Umbrella umbrella(edges_of(t.triangles), n);
  const Mat3 r = random_rotations(1, 6).front();
  const Points carried =
      carried_laplacian(umbrella, t.points, std::vector<Mat3>(static_cast<size_t>(n), r));
  const Points moved = (t.points * r.transpose()).rowwise() + Eigen::RowVector3d(3, -2, 5);
  EXPECT_LT(bending_energy(1, umbrella, moved, carried), 1e-26);
}

}  // namespace
}  // namespace vasorod
