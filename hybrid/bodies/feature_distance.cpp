#include "bodies/feature_distance.h"

#include <Eigen/Dense>
#include <algorithm>
#include <vector>

#include "geometry/closest_point.h"

namespace vasorod {
namespace {

// Squared sine of the angle below which two edges count as parallel.
constexpr double parallel = 1e-12;

std::array<double, 4> of_triangle(const FeatureCorners& x) {
  const Vec3 b = closest_in_triangle(x[0], x[1], x[2], x[3]);
  return {1, -b[0], -b[1], -b[2]};
}

std::array<double, 4> of_edges(const FeatureCorners& x) {
  const Vec3 first = x[1] - x[0], second = x[3] - x[2], r = x[0] - x[2];
  const double a = first.squaredNorm(), e = second.squaredNorm(), f = second.dot(r),
               c = first.dot(r), b = first.dot(second), determinant = a * e - b * b;
  double s =
      determinant > parallel * a * e ? std::clamp((b * f - c * e) / determinant, 0.0, 1.0) : 0;
  double t = (b * s + f) / e;
  if (t < 0) {
    t = 0;
    s = std::clamp(-c / a, 0.0, 1.0);
  } else if (t > 1) {
    t = 1;
    s = std::clamp((b - c) / a, 0.0, 1.0);
  }
  return {1 - s, s, t - 1, -t};
}

// Changes of the weights along which both points stay inside their features.
std::vector<Eigen::Vector4d> free_changes(const std::array<double, 4>& weight, Features features) {
  std::vector<Eigen::Vector4d> changes;
  const auto along = [&](int from, int to) {
    changes.push_back(Eigen::Vector4d::Unit(from) - Eigen::Vector4d::Unit(to));
  };
  if (features == Features::two_edges) {
    if (weight[0] > 0 && weight[1] > 0) along(0, 1);
    if (weight[2] < 0 && weight[3] < 0) along(2, 3);
    return changes;
  }
  int base = -1;
  for (int k = 1; k < 4; ++k) {
    if (!(weight[static_cast<size_t>(k)] < 0)) continue;
    if (base >= 0) along(base, k);
    base = base < 0 ? k : base;
  }
  return changes;
}

}  // namespace

FeatureDistance feature_distance(const FeatureCorners& x, Features features) {
  FeatureDistance found;
  found.weight = features == Features::two_edges ? of_edges(x) : of_triangle(x);
  for (size_t k = 0; k < 4; ++k) found.apart += found.weight[k] * x[k];
  found.distance = found.apart.norm();
  return found;
}

Eigen::Matrix<double, 12, 12> half_square_hessian(const FeatureCorners& x,
                                                  const FeatureDistance& found, Features features) {
  Eigen::Matrix<double, 12, 12> hessian;
  for (int k = 0; k < 4; ++k)
    for (int l = 0; l < 4; ++l)
      hessian.block<3, 3>(3 * k, 3 * l) = found.weight[static_cast<size_t>(k)] *
                                          found.weight[static_cast<size_t>(l)] * Mat3::Identity();
  const std::vector<Eigen::Vector4d> changes = free_changes(found.weight, features);
  const auto count = static_cast<Eigen::Index>(changes.size());
  if (count == 0) return hessian;
  // With the free weights q, distance^2 / 2 has the second derivatives `mixed` by x and q and
  // `inner` by q; at its minimum over q the Hessian by x loses mixed inner^-1 mixed^T.
  Eigen::Matrix<double, 12, Eigen::Dynamic, 0, 12, 2> mixed(12, count);
  Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, 2> moves = decltype(moves)::Zero(3, count);
  for (Eigen::Index i = 0; i < count; ++i)
    for (int k = 0; k < 4; ++k)
      moves.col(i) += changes[static_cast<size_t>(i)][k] * x[static_cast<size_t>(k)];
  for (Eigen::Index i = 0; i < count; ++i)
    for (int k = 0; k < 4; ++k)
      mixed.block<3, 1>(3 * k, i) = found.weight[static_cast<size_t>(k)] * moves.col(i) +
                                    changes[static_cast<size_t>(i)][k] * found.apart;
  const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 2, 2> inner =
      moves.transpose() * moves;
  const Eigen::FullPivLU<Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 2, 2>> solve(
      inner);
  if (solve.isInvertible()) hessian -= mixed * solve.solve(mixed.transpose());
  return hessian;
}

}  // namespace vasorod
