#include "sections/lumen_point.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "geometry/rigid_motion.h"

namespace vasorod {
namespace {

constexpr double least_area = 1e-12;  // of a point, over its area at rest: a line has no normal

// Columns of the jet.
enum { X, U, T };

}  // namespace

LumenPoint::LumenPoint(double area, double depth, double thinning, double measure)
    : area_(area), tissue_(depth * area), thinning_(thinning), measure_(measure) {}

PointVolume LumenPoint::volume(const Mat3& jet, bool with_hessian) const {
  const Vec3 x = jet.col(X), u = jet.col(U), t = jet.col(T), area = t.cross(u);
  const double size = std::max(area.norm(), least_area * area_);
  const Vec3 n = area / size;
  const double tissue = tissue_ * std::pow(size / area_, thinning_),
               slope = thinning_ * tissue / size;
  PointVolume volume;
  volume.value = measure_ * (x.dot(area) / 3 - tissue);
  volume.gradient.col(X) = measure_ / 3 * area;
  volume.gradient.col(U) = measure_ * (x.cross(t) / 3 - slope * n.cross(t));
  volume.gradient.col(T) = measure_ * (u.cross(x) / 3 - slope * u.cross(n));
  if (!with_hessian) return volume;
  auto& h = volume.hessian;
  h.setZero();
  const auto put = [&](int a, int b, const Mat3& block) {
    h.block<3, 3>(3 * a, 3 * b) += block;
    if (a != b) h.block<3, 3>(3 * b, 3 * a) += block.transpose();
  };
  put(X, U, hat(t) / 3);
  put(X, T, -hat(u) / 3);
  put(U, T, hat(x) / 3);
  // Of A: d(area) = t x du - u x dt; n . d2(area) = 2 n . (dt x du).
  const Mat3 by_u = hat(t), by_t = -hat(u), across = Mat3::Identity() - n * n.transpose();
  const Vec3 along_u = n.cross(t), along_t = u.cross(n);
  const double bend = slope * (thinning_ - 1) / size;
  const auto of_area = [&](const Mat3& a, const Mat3& b) -> Mat3 {
    return a.transpose() * across * b / size;
  };
  put(U, U, -slope * of_area(by_u, by_u) - bend * along_u * along_u.transpose());
  put(T, T, -slope * of_area(by_t, by_t) - bend * along_t * along_t.transpose());
  put(U, T, -slope * (of_area(by_u, by_t) + hat(n)) - bend * along_u * along_t.transpose());
  h *= measure_;
  return volume;
}

}  // namespace vasorod
