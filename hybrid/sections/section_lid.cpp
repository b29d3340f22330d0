#include "sections/section_lid.h"

#include <Eigen/Geometry>
#include <numbers>

#include "geometry/rigid_motion.h"
#include "sections/harmonics.h"

namespace vasorod {
namespace {

using Eigen::VectorXd;
using std::numbers::pi;

}  // namespace

double SectionLid::add_gradient(const VectorXd& row, double factor,
                                Eigen::Ref<VectorXd> gradient) const {
  const Vec3 c = mode(row, 0);
  const auto add = [&](int m, const Vec3& value) {
    for (int k = 0; k < 3; ++k) gradient[k * modes() + m] += factor * value[k];
  };
  Vec3 area = Vec3::Zero();
  for (int k = 1; k <= harmonics_; ++k) {
    const Vec3 a = mode(row, 2 * k - 1), b = mode(row, 2 * k);
    const double share = sign_ * pi * k / 3;
    area += pi * k * a.cross(b);
    add(2 * k - 1, share * b.cross(c));
    add(2 * k, share * c.cross(a));
  }
  add(0, sign_ / 3 * area);
  return sign_ * c.dot(area) / 3;
}

void SectionLid::add_hessian(const VectorXd& row, double factor, Eigen::MatrixXd& hessian) const {
  const auto put = [&](int m, int n, const Mat3& block) {
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        hessian(i * modes() + m, j * modes() + n) += block(i, j);
        hessian(j * modes() + n, i * modes() + m) += block(i, j);
      }
  };
  const Vec3 c = mode(row, 0);
  for (int k = 1; k <= harmonics_; ++k) {
    const Vec3 a = mode(row, 2 * k - 1), b = mode(row, 2 * k);
    const double share = factor * sign_ * pi * k / 3;
    put(0, 2 * k - 1, -share * hat(b));  // d/da of a x b
    put(0, 2 * k, share * hat(a));
    put(2 * k - 1, 2 * k, -share * hat(c));  // d/db of b x c
  }
}

void SectionLid::wrench(const VectorXd& row, double depth, const Vec3& center, Vec3& force,
                        Vec3& moment) const {
  const int points = 8 * harmonics_ + 8;
  const VectorXd angles = VectorXd::LinSpaced(points, 0, 2 * pi * (points - 1) / points);
  const Eigen::MatrixX3d x = harmonic_values(angles, harmonics_, 0) * row.reshaped(modes(), 3),
                         slope = harmonic_values(angles, harmonics_, 1) * row.reshaped(modes(), 3);
  const double step = 2 * pi / points;
  const Vec3 tip = mode(row, 0);
  force = moment = Vec3::Zero();
  Vec3 ring_force = Vec3::Zero();
  double ring = 0;
  for (int q = 0; q < points; ++q) {
    const Vec3 at = x.row(q), along = slope.row(q);
    const Vec3 triangle = sign_ * step / 2 * (at - tip).cross(along);
    force += triangle;
    moment += ((tip + 2 * at) / 3 - center).cross(triangle);
    ring += step * depth * along.norm();
    ring_force += step * depth * along.norm() * (at - center);
  }
  const Vec3 normal = force.normalized();
  force -= ring * normal;
  moment -= ring_force.cross(normal);
}

}  // namespace vasorod
