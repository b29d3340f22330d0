// Arc length along a spline curve.
#pragma once

#include <vasorod/types.h>

#include "vessel/spline.h"

namespace vasorod {

/// Arc length of the curve from its start, by 5-point Gauss quadrature on every knot interval.
/// Negative before the start; the curve goes on straight beyond its ends.
class ArcLength {
 public:
  explicit ArcLength(const Spline<3>& axis) : axis_(axis) {
    for (int i = 0; i < axis_.intervals; ++i) {
      // The basis' derivatives, sorted by powers.
      const Vec3* p = axis_.control.data() + i;
      velocity_.push_back(
          {(p[2] - p[0]) / 2, p[0] - 2 * p[1] + p[2], (p[3] - p[0] + 3 * (p[1] - p[2])) / 2});
      at_knot_.push_back(at_knot_.back() + velocity_.back().length(1));
    }
  }
  double operator()(double u) const {
    const double at = (u - axis_.start) / axis_.step(), last = axis_.intervals;
    if (!(at > 0)) return at * velocity_.front().speed(0);
    if (at > last) return at_knot_.back() + (at - last) * velocity_.back().speed(1);
    const int i = std::min(static_cast<int>(at), axis_.intervals - 1);
    return at_knot_[static_cast<size_t>(i)] + velocity_[static_cast<size_t>(i)].length(at - i);
  }
  double inverse(double length) const {
    double u = axis_.start + length / at_knot_.back() * (axis_.end - axis_.start);
    for (int k = 0; k < 20; ++k) {
      const double step = ((*this)(u)-length) / axis_.derivative(u).norm();
      u -= step;
      if (std::abs(step) < 1e-15 * at_knot_.back()) break;
    }
    return u;
  }

 private:
  // The derivative by the place t in an interval, constant + linear t + square t^2.
  struct Velocity {
    Vec3 constant, linear, square;
    double speed(double t) const { return (constant + t * (linear + t * square)).norm(); }
    // From the interval's start to t.
    double length(double t) const {
      constexpr std::array<double, 3> x{0, 0.538469310105683, 0.906179845938664};
      constexpr std::array<double, 3> w{0.568888888888889, 0.478628670499366, 0.236926885056189};
      const double half = 0.5 * t;
      double sum = w[0] * speed(half);
      for (size_t k = 1; k < 3; ++k)
        sum += w[k] * (speed(half - half * x[k]) + speed(half + half * x[k]));
      return half * sum;
    }
  };
  const Spline<3>& axis_;
  std::vector<Velocity> velocity_;
  std::vector<double> at_knot_{0};
};

}  // namespace vasorod
