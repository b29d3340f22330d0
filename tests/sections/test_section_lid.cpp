#include <gtest/gtest.h>
#include <numbers>

#include "sections/section_lid.h"
#include "some_tube.h"
#include "wall/lumen.h"

namespace vasorod {
namespace {

using Eigen::MatrixXd, Eigen::VectorXd;
using std::numbers::pi;
using testing::disturbed, testing::straight_shape;

const SectionSpace space{4, AxialBasis(5, 3)};

// The rim of a disturbed tube at its start, moved.
VectorXd some_row() {
  const SectionShape shape = disturbed(straight_shape(space, 1.1, 4.2), 0.07);
  return testing::moved(shape, {exp_rotation(Vec3(0.4, -0.3, 0.2)), Vec3(1, -2, 0.5)}).col(0);
}

TEST(SectionLid, DerivativesMatchDifferences) {
  for (const bool last : {false, true}) {
    const SectionLid lid(space.harmonics, last);
    const VectorXd row = some_row();
    const auto gradient = [&](const VectorXd& at, double* value = nullptr) {
      VectorXd g = VectorXd::Zero(at.size());
      const double volume = lid.add_gradient(at, 1, g);
      if (value) *value = volume;
      return g;
    };
    const VectorXd g = gradient(row);
    MatrixXd hessian = MatrixXd::Zero(row.size(), row.size());
    lid.add_hessian(row, 1, hessian);
    const double h = 1e-5;
    for (Eigen::Index k = 0; k < row.size(); ++k) {
      VectorXd before = row, after = row;
      before[k] -= h;
      after[k] += h;
      double low = 0, high = 0;
      const VectorXd change = (gradient(after, &high) - gradient(before, &low)) / (2 * h);
      EXPECT_NEAR((high - low) / (2 * h), g[k], 1e-9);
      EXPECT_LT((change - hessian.col(k)).norm(), 1e-8);
    }
  }
}

// The triangles of lumen.h, of which the fan is the limit.
TEST(SectionLid, IsTheLimitOfAFanOfTriangles) {
  const VectorXd row = some_row();
  const int around = 2000;
  const VectorXd angles = VectorXd::LinSpaced(around, 0, 2 * pi * (around - 1) / around);
  Points rim = harmonic_values(angles, space.harmonics, 0) * row.reshaped(space.modes(), 3);
  const Vec3 mean = rim.colwise().mean(), center(0.2, 0.1, -0.4);
  // A surface whose boundary is the rim alone: the fan looks against the direction of its loop.
  TriangleSurface disk;
  disk.points.resize(around + 1, 3);
  disk.points << rim, mean.transpose();
  disk.triangles.resize(around, 3);
  std::vector<int> loop;
  for (int k = 0; k < around; ++k) {
    disk.triangles.row(k) << k, (k + 1) % around, around;
    loop.push_back(k);
  }
  const double depth = 0.1;
  const Lumen lumen(disk, VectorXd::Constant(around + 1, depth), 1, {{loop, false}});
  const Points force = lumen.lid_force(disk.points, 0);
  Vec3 sum = Vec3::Zero(), moment = Vec3::Zero();
  for (Eigen::Index v = 0; v < force.rows(); ++v) {
    sum += force.row(v).transpose();
    moment += (Vec3(disk.points.row(v)) - center).cross(Vec3(force.row(v)));
  }
  Vec3 found, found_moment;
  SectionLid(space.harmonics, false).wrench(row, depth, center, found, found_moment);
  EXPECT_LT((found - sum).norm(), 1e-5 * sum.norm());
  EXPECT_LT((found_moment - moment).norm(), 1e-5 * moment.norm());
  Vec3 other, other_moment;
  SectionLid(space.harmonics, true).wrench(row, depth, center, other, other_moment);
  EXPECT_LT((found + other).norm() + (found_moment + other_moment).norm(), 1e-13);
}

TEST(SectionLid, OfACircleItIsACone) {
  VectorXd row = VectorXd::Zero(space.row_size());
  row[1] = row[space.modes() + 2] = 2;
  row[2 * space.modes()] = 7;
  VectorXd unused = VectorXd::Zero(row.size());
  EXPECT_NEAR(SectionLid(space.harmonics, true).add_gradient(row, 1, unused), 4 * pi * 7 / 3,
              1e-12);
  Vec3 force, moment;
  SectionLid(space.harmonics, true).wrench(row, 0.1, Vec3(1, 0, 0), force, moment);
  EXPECT_LT((force - Vec3(0, 0, pi * (4 - 0.4))).norm(), 1e-12);
  EXPECT_LT((moment - Vec3(-1, 0, 7).cross(force)).norm(), 1e-11);
}

}  // namespace
}  // namespace vasorod
