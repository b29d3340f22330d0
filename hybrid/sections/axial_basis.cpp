#include "sections/axial_basis.h"

#include <algorithm>
#include <cmath>
#include <unsupported/Eigen/Splines>

namespace vasorod {
namespace {

using Spline1 = Eigen::Spline<double, 1, Eigen::Dynamic>;

}  // namespace

AxialBasis::AxialBasis(int spans, int degree) : degree_(degree) {
  constexpr double grading = 1.2;
  knots_.resize(spans + 2 * degree + 1);
  for (int k = 0; k < knots_.size(); ++k) {
    const double v = 2.0 * std::clamp(k - degree, 0, spans) / spans - 1;
    knots_[k] = (1 + std::tanh(grading * v) / std::tanh(grading)) / 2;
  }
}

AxialBasis::Values AxialBasis::at(double u) const {
  const double* first = knots_.data() + degree_;
  const auto above = std::upper_bound(first, first + spans() + 1, u) - first;
  return at(u, std::clamp(static_cast<int>(above) - 1, 0, spans() - 1));
}

AxialBasis::Values AxialBasis::at(double u, int span) const {
  // Eigen looks for the span itself and at a knot takes the one above.
  const double from = begin(span), to = end(span);
  const double inside = std::clamp(u, from, std::nextafter(to, from));
  return {span, Spline1::BasisFunctionDerivatives(inside, 2, degree_, knots_)};
}

Eigen::VectorXd AxialBasis::interpolation_points() const {
  Eigen::VectorXd points(count());
  for (int i = 0; i < count(); ++i) points[i] = knots_.segment(i + 1, degree_).mean();
  return points;
}

}  // namespace vasorod
