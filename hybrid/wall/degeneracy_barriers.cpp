#include "wall/degeneracy_barriers.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vasorod {

namespace {

// These bounds keep the barriers finite.
constexpr double least_angle = 1e-6, least_area = 1e-8;
constexpr double least_free_area = 0.5;

}  // namespace

FoldBarrier::FoldBarrier(double half_sine, double half_cosine) {
  if (half_cosine > std::numbers::sqrt2 / 2) return;
  const double half_angle = std::atan2(std::abs(half_sine), half_cosine);
  const double x = half_angle - std::numbers::pi / 4;
  const double left = std::max(std::numbers::pi / 2 - half_angle, least_angle);
  const double side = std::copysign(1.0, half_sine);
  value = side * x * x * x / left;
  first = (3 * x * x + x * x * x / left) / left;
  second = side * (6 * x + (6 * x * x + 2 * x * x * x / left) / left) / left;
}

CollapseBarrier::CollapseBarrier(const Vec3& c) {
  const double det = c[0] * c[1] - c[2] * c[2];
  if (det > least_free_area * least_free_area) return;
  const double j = std::sqrt(std::max(det, least_area * least_area));
  const double x = least_free_area - j;
  value = x * x * x / j;
  const double first = -(3 * x * x + x * x * x / j) / j;
  const double second = (6 * x + (6 * x * x + 2 * x * x * x / j) / j) / j;
  const Vec3 by_metric = Vec3(c[1], c[0], -2 * c[2]) / (2 * j);  // d J
  gradient = first * by_metric;
  hessian = (second - first / j) * by_metric * by_metric.transpose();
  hessian(0, 1) += first / (2 * j);
  hessian(1, 0) += first / (2 * j);
  hessian(2, 2) -= first / j;
}

}  // namespace vasorod
