// Penalised uniform cubic B-splines (P-splines, Eilers and Marx 1996) through scattered data.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace vasorod {

/// A uniform cubic B-spline with values in R^D on [start, end], extended linearly.
template <int D>
struct Spline {
  using Value = Eigen::Matrix<double, D, 1>;
  double start = 0, end = 1;
  int intervals = 1;
  std::vector<Value> control;  ///< intervals + 3

  double step() const { return (end - start) / intervals; }

  /// Interval of u inside the domain, and how far u is into it, 0 to 1.
  std::pair<int, double> place(double u) const {
    const double x = (u - start) / step();
    const int i = std::clamp(static_cast<int>(x), 0, intervals - 1);
    return {i, x - i};
  }
  /// The four basis values (order 0) or their derivatives by the place (order 1, 2) at t.
  static std::array<double, 4> basis(double t, int order = 0) {
    const double r = 1 - t;
    if (order == 0)
      return {r * r * r / 6, (3 * t * t * t - 6 * t * t + 4) / 6,
              (3 * r * r * r - 6 * r * r + 4) / 6, t * t * t / 6};
    if (order == 1)
      return {-r * r / 2, (3 * t * t - 4 * t) / 2, (4 * r - 3 * r * r) / 2, t * t / 2};
    return {r, 3 * t - 2, 3 * r - 2, t};
  }
  /// The same basis times the control points of interval i.
  Value at(int i, double t, int order) const {
    const std::array<double, 4> b = basis(t, order);
    Value value = Value::Zero();
    for (size_t k = 0; k < 4; ++k) value += b[k] * control[static_cast<size_t>(i) + k];
    return value;
  }
  /// Value, first and second derivative.
  std::array<Value, 3> jet(double u) const {
    if (u < start || u > end) return {(*this)(u), derivative(u), Value::Zero()};
    const auto [i, t] = place(u);
    const double h = step();
    return {at(i, t, 0), at(i, t, 1) / h, at(i, t, 2) / (h * h)};
  }
  Value operator()(double u) const {
    const double inside = std::clamp(u, start, end);
    const auto [i, t] = place(inside);
    Value value = at(i, t, 0);
    if (u != inside) value += (u - inside) / step() * at(i, t, 1);
    return value;
  }
  Value derivative(double u) const {
    const auto [i, t] = place(std::clamp(u, start, end));
    return at(i, t, 1) / step();
  }
  Value second(double u) const {
    if (u < start || u > end) return Value::Zero();
    const auto [i, t] = place(u);
    return at(i, t, 2) / (step() * step());
  }
};

/// One data point: value at u, with a weight.
template <int D>
struct SplineDatum {
  double u = 0, weight = 0;
  Eigen::Matrix<double, D, 1> value = Eigen::Matrix<double, D, 1>::Zero();
};

/// Penalties on the squared differences of the control points. `second` does not affect straight
/// lines, `third` does not affect parabolas.
struct Smoothing {
  double second = 0, third = 0;
};

/// Minimises sum weight |spline(u) - value|^2 + the penalties, in O(data + intervals). Data outside
/// the domain are ignored. `spline` gives domain and intervals; its control points are replaced.
template <int D>
void fit_penalised(Spline<D>& spline, const std::vector<SplineDatum<D>>& data,
                   const Smoothing& smoothing) {
  const size_t n = static_cast<size_t>(spline.intervals) + 3;
  // Symmetric band matrix: band[i][k] is the entry (i, i + k).
  std::vector<std::array<double, 4>> band(n, {0, 0, 0, 0});
  std::vector<Eigen::Matrix<double, D, 1>> right(n, Eigen::Matrix<double, D, 1>::Zero());
  for (const auto& d : data) {
    if (d.weight <= 0 || d.u < spline.start || d.u > spline.end) continue;
    const auto [interval, t] = spline.place(d.u);
    const std::array<double, 4> b = Spline<D>::basis(t);
    const auto i = static_cast<size_t>(interval);
    for (size_t j = 0; j < 4; ++j) {
      for (size_t k = j; k < 4; ++k) band[i + j][k - j] += d.weight * b[j] * b[k];
      right[i + j] += d.weight * b[j] * d.value;
    }
  }
  auto penalise = [&](const std::vector<double>& difference, double penalty) {
    for (size_t i = 0; i + difference.size() <= n; ++i)
      for (size_t j = 0; j < difference.size(); ++j)
        for (size_t k = j; k < difference.size(); ++k)
          band[i + j][k - j] += penalty * difference[j] * difference[k];
  };
  penalise({1, -2, 1}, smoothing.second);
  penalise({-1, 3, -3, 1}, smoothing.third);
  // L D L^T in place.
  for (size_t i = 0; i < n; ++i) {
    const double pivot = band[i][0];
    for (size_t j = 1; j < 4 && i + j < n; ++j) {
      const double factor = band[i][j] / pivot;
      for (size_t k = j; k < 4 && i + k < n; ++k) band[i + j][k - j] -= factor * band[i][k];
      right[i + j] -= factor * right[i];
    }
  }
  for (size_t i = n; i-- > 0;) {
    for (size_t j = 1; j < 4 && i + j < n; ++j) right[i] -= band[i][j] * right[i + j];
    right[i] /= band[i][0];
  }
  spline.control = std::move(right);
}

}  // namespace vasorod
