#include "reference_fem/mouth.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace vasorod::fem {
namespace {

/// Area vector, length and centroid of a closed polygon.
struct Curve {
  Vec3 area = Vec3::Zero(), centroid = Vec3::Zero();
  double length = 0;
};

Curve curve_of(const Points& points) {
  const Vec3 middle = points.colwise().mean();
  const Eigen::Index n = points.rows();
  const auto corner = [&](Eigen::Index k) { return Vec3(points.row(k % n).transpose() - middle); };
  Curve curve;
  for (Eigen::Index k = 0; k < n; ++k) {
    curve.area += 0.5 * corner(k).cross(corner(k + 1));
    curve.length += (corner(k + 1) - corner(k)).norm();
  }
  const Vec3 normal = curve.area.normalized();
  for (Eigen::Index k = 0; k < n; ++k)
    curve.centroid +=
        0.5 * corner(k).cross(corner(k + 1)).dot(normal) * (corner(k) + corner(k + 1)) / 3;
  if (curve.area.norm() > 0) curve.centroid /= curve.area.norm();
  curve.centroid += middle;
  return curve;
}

/// Area inside a curve moved inwards (Steiner).
double inset(const Curve& curve, double distance) {
  if (2 * std::numbers::pi * distance >= curve.length) return 0;
  return std::max(
      0.0, curve.area.norm() - distance * curve.length + std::numbers::pi * distance * distance);
}

}  // namespace

MouthReport mouth_of(const Points& seam, const Points& rest, double thickness) {
  const Curve now = curve_of(seam), before = curve_of(rest);
  MouthReport mouth;
  mouth.area = now.area.norm();
  mouth.lumen = inset(now, thickness / 2);
  mouth.area_ratio = mouth.lumen / inset(before, thickness / 2);
  mouth.perimeter = now.length;
  mouth.perimeter_ratio = now.length / before.length;
  mouth.center = now.centroid;

  const Vec3 normal = now.area.normalized();
  const Points flat = seam - (seam * normal) * normal.transpose();
  Vec3 across = Vec3::Zero();
  for (Eigen::Index i = 0; i < flat.rows(); ++i)
    for (Eigen::Index j = i + 1; j < flat.rows(); ++j)
      if ((flat.row(j) - flat.row(i)).squaredNorm() > across.squaredNorm())
        across = flat.row(j) - flat.row(i);
  mouth.span = across.norm();
  const Eigen::VectorXd side = flat * normal.cross(across).normalized();
  mouth.width = side.maxCoeff() - side.minCoeff();
  return mouth;
}

}  // namespace vasorod::fem
