#include "wall/neo_hookean.h"

#include <cmath>

namespace vasorod {

namespace {

// Halley's iteration on s: an error after a step d is about d^3.
constexpr double enough = 1e-5;
constexpr int most_steps = 50;

// e^-d - 1
double shrunk(double d) {
  return std::abs(d) < 1e-3 ? -d * (1 - d / 2 * (1 - d / 3 * (1 - d / 4))) : std::expm1(-d);
}

AreaEnergy law(double excess, double nu) {
  const double j = 1 + excess, log_j = std::log1p(excess), shares = 1 - 2 * nu;
  // the first two terms of the series in ln j
  const double slope = -2 * nu / (1 - nu);
  double s = slope * log_j * (1 - shares * slope / (2 * (1 - nu)) * log_j);
  double grown = std::expm1(s);  // l^2 - 1
  for (int k = 0; k < most_steps; ++k) {
    const double f = shares * grown + nu * (2 * log_j + s), second = shares * (grown + 1),
                 first = second + nu;
    const double step = f * first / (first * first - f * second / 2);
    s -= step;
    grown += (grown + 1) * shrunk(step);
    if (std::abs(step) <= enough) break;
  }
  const double log_volume = log_j + s / 2;
  const double by_log = -2 * nu / (shares * (grown + 1) + nu);  // ds / d ln j
  return {(excess - log_j) + (grown - s) / 2 - grown * log_volume / 2, (excess - grown) / j,
          (grown + 1) * (1 - by_log) / (j * j)};
}

}  // namespace

AreaEnergy neo_hookean_area(double excess, double poisson) {
  const double below = excess - (least_area_of_law - 1);
  if (below >= 0) return law(excess, poisson);
  const AreaEnergy at = law(least_area_of_law - 1, poisson);
  return {at.value + below * (at.first + below * at.second / 2), at.first + below * at.second,
          at.second};
}

}  // namespace vasorod
