#include <gtest/gtest.h>
#include <random>

#include "geometry/rigid_motion.h"
#include "geometry/triangle_surface.h"
#include "straight_tube.h"
#include "wall/lumen.h"

namespace vasorod {
namespace {

Points shaken(Points x, double size) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(-size, size);
  for (Eigen::Index i = 0; i < x.size(); ++i) x.data()[i] += uniform(random);
  return x;
}

std::vector<LumenFan> closed(const TriangleSurface& surface, bool from_first = false) {
  std::vector<LumenFan> fans;
  for (const auto& loop : boundary_loops(surface.triangles)) fans.push_back({loop, from_first});
  return fans;
}

// By the divergence theorem along z; the ends of the tube are flat, at 0 and `length`.
double volume_of_prism(const TriangleSurface& tube, double length, double end_area) {
  double volume = length * end_area;
  for (int t = 0; t < tube.triangles.rows(); ++t) {
    const Vec3 a = tube.points.row(tube.triangles(t, 0)), b = tube.points.row(tube.triangles(t, 1)),
               c = tube.points.row(tube.triangles(t, 2));
    volume += (a.z() + b.z() + c.z()) / 3 * (b - a).cross(c - a).z() / 2;
  }
  return volume;
}

TEST(Lumen, ATubesVolumeIsThatOfItsSurfaceLessTheTissue) {
  const TriangleSurface tube = tube_surface(testing::straight_tube(30, 5, 40, 12));
  const double radius = tube.points.row(0).head<2>().norm();
  const double prism =
      volume_of_prism(tube, 30, 40 * 0.5 * radius * radius * std::sin(2 * M_PI / 40));
  EXPECT_NEAR(prism, 30 * M_PI * 25, 0.01 * prism);
  for (const bool from_first : {false, true}) {
    const Lumen lumen(tube, Eigen::VectorXd::Constant(tube.points.rows(), 0.4), 0.3,
                      closed(tube, from_first));
    EXPECT_NEAR(lumen.volume(tube.points), prism - 0.4 * total_area(tube), 1e-10 * prism);
    // Twice as large, the tissue takes 2^(2 m) times its volume.
    EXPECT_NEAR(lumen.volume(2 * tube.points),
                8 * prism - 0.4 * total_area(tube) * std::pow(2, 0.6), 1e-10 * prism);
  }
}

TEST(Lumen, DerivativesMatchDifferences) {
  const TriangleSurface tube = tube_surface(testing::straight_tube(4, 1.5, 7, 3));
  std::vector<LumenFan> fans = closed(tube);
  fans[1].from_first = true;
  const Lumen lumen(tube, shaken(tube.points, 0.1).col(0).cwiseAbs(), 0.4, fans);
  const Points x = shaken(tube.points, 0.2);
  const auto gradient = [&](const Points& at) {
    Points g = Points::Zero(at.rows(), 3);
    lumen.add_gradient(at, 1, g);
    return g;
  };
  const Points g = gradient(x);
  std::vector<Eigen::Triplet<double>> entries;
  lumen.add_hessian(x, 1, 0, entries);
  Eigen::SparseMatrix<double> lower(x.size(), x.size());
  lower.setFromTriplets(entries.begin(), entries.end());
  const Eigen::MatrixXd dense = lower, hessian = dense.selfadjointView<Eigen::Lower>();
  for (const auto& entry : entries) EXPECT_GE(entry.row(), entry.col());
  const double step = 1e-5;
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    Points up = x, down = x;
    up.data()[i] += step;
    down.data()[i] -= step;
    EXPECT_NEAR((lumen.volume(up) - lumen.volume(down)) / (2 * step), g.data()[i], 1e-8);
    const Points column = (gradient(up) - gradient(down)) / (2 * step);
    EXPECT_LT((Eigen::Map<const Eigen::VectorXd>(column.data(), column.size()) - hessian.col(i))
                  .cwiseAbs()
                  .maxCoeff(),
              1e-8);
  }
}

TEST(Lumen, ARigidMotionChangesNothingAndPressureHasNoResultant) {
  const TriangleSurface tube = tube_surface(testing::straight_tube(4, 1.5, 7, 3));
  const Points x = shaken(tube.points, 0.2);
  const Lumen lumen(tube, Eigen::VectorXd::Constant(x.rows(), 0.2), 0.4, closed(tube));
  const Mat3 turn = exp_rotation(Vec3(0.7, -0.4, 1.1));
  const Points moved = (x * turn.transpose()).rowwise() + Vec3(20, -30, 50).transpose();
  EXPECT_NEAR(lumen.volume(moved), lumen.volume(x), 1e-10);
  Points g = Points::Zero(x.rows(), 3);
  lumen.add_gradient(moved, 1, g);
  EXPECT_LT(g.colwise().sum().norm(), 1e-11);
  Vec3 moment = Vec3::Zero();
  for (Eigen::Index i = 0; i < g.rows(); ++i) moment += Vec3(moved.row(i)).cross(Vec3(g.row(i)));
  EXPECT_LT(moment.norm(), 1e-9);
}

TEST(Lumen, FansOfTwoRimsThatLieOnEachOtherCancel) {
  const TriangleSurface tube = tube_surface(testing::straight_tube(4, 1.5, 7, 3));
  const Lumen lumen(tube, Eigen::VectorXd::Zero(tube.points.rows()), 1, closed(tube, true));
  // The other rim runs the other way round, from the same vertex.
  std::vector<LumenFan> other = closed(tube, true);
  std::reverse(other[0].loop.begin() + 1, other[0].loop.end());
  const Lumen reversed(tube, Eigen::VectorXd::Zero(tube.points.rows()), 1, other);
  const Points x = shaken(tube.points, 0.2);
  EXPECT_GT(lumen.lid_force(x, 0).norm(), 1);
  EXPECT_LT((lumen.lid_force(x, 0) + reversed.lid_force(x, 0)).norm(), 1e-13);
}

TEST(Lumen, ALidFeelsThePressureOnItsArea) {
  const TriangleSurface tube = tube_surface(testing::straight_tube(4, 1.5, 12, 3));
  const double area = 6 * tube.points.row(0).head<2>().squaredNorm() * std::sin(2 * M_PI / 12);
  for (const bool from_first : {false, true}) {
    const Lumen lumen(tube, Eigen::VectorXd::Zero(tube.points.rows()), 1, closed(tube, from_first));
    const Points moved = tube.points.rowwise() + Vec3(20, -30, 50).transpose();
    for (const auto& [fan, sign] : {std::pair(0, -1), {1, 1}})
      EXPECT_LT((lumen.lid_force(moved, fan).colwise().sum() - Vec3(0, 0, sign * area).transpose())
                    .norm(),
                1e-12);
  }
}

TEST(Lumen, ThinningFollowsFromPlaneStress) {
  EXPECT_NEAR(thinning_exponent(Material::isotropic(2, 0.3)), 0.4 / 0.7, 1e-14);
  EXPECT_NEAR(thinning_exponent(Material::isotropic(2, 0.5)), 0, 1e-14);
  EXPECT_NEAR(thinning_exponent(Material::isotropic(2, 0)), 1, 1e-14);
  // An isotropic material in the words of a fibre's.
  Material fibre = Material::isotropic(2, 0.3);
  fibre.young_axial = 2 + 1e-9;
  EXPECT_NEAR(thinning_exponent(fibre), 0.4 / 0.7, 1e-8);
}

}  // namespace
}  // namespace vasorod
