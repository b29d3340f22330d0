#include <gtest/gtest.h>

#include "paper/bending_energy.h"
#include "paper/paper_tubes.h"

namespace vasorod {
namespace {

using namespace testing;

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
