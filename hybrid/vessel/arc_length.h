// Arc length along a spline curve.
#pragma once

#include "vessel/spline.h"

namespace vasorod {

/// Arc length of the curve from its start, by 5-point Gauss quadrature on every knot interval.
/// Negative before the start.
class ArcLength {
 public:
  explicit ArcLength(const Spline<3>& axis) : axis_(axis) {
    for (int i = 0; i < axis_.intervals; ++i)
      at_knot_.push_back(at_knot_.back() + integral(knot(i), knot(i + 1)));
  }
  double operator()(double u) const {
    // Held to the intervals before it becomes an int, which would not hold every double.
    const double at = (u - axis_.start) / axis_.step();
    const int i = at > 0 ? static_cast<int>(std::min(at, axis_.intervals - 1.0)) : 0;
    return at_knot_[static_cast<size_t>(i)] + integral(knot(i), u);
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
  double knot(int i) const { return axis_.start + i * axis_.step(); }
  double integral(double a, double b) const {
    constexpr std::array<double, 3> x{0, 0.538469310105683, 0.906179845938664};
    constexpr std::array<double, 3> w{0.568888888888889, 0.478628670499366, 0.236926885056189};
    const double middle = 0.5 * (a + b), half = 0.5 * (b - a);
    double sum = w[0] * axis_.derivative(middle).norm();
    for (size_t k = 1; k < 3; ++k)
      sum += w[k] * (axis_.derivative(middle - half * x[k]).norm() +
                     axis_.derivative(middle + half * x[k]).norm());
    return half * sum;
  }
  const Spline<3>& axis_;
  std::vector<double> at_knot_{0};
};

}  // namespace vasorod
