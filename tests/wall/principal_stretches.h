// The neo-Hookean law in principal stretches, computed without the formulas of wall/neo_hookean.h:
// an independent check.
#pragma once

#include <cmath>

namespace vasorod {

/// The energy per volume over mu of the stretches l1 and l2 in the plane, with the third where the
/// stress across the wall is zero (bisection).
inline double neo_hookean_of_stretches(double l1, double l2, double nu) {
  const double lambda = 2 * nu / (1 - 2 * nu);  // over mu
  const auto across = [&](double l3) { return l3 * l3 - 1 + lambda * std::log(l1 * l2 * l3); };
  double low = 1e-4, high = 1e4;
  for (int k = 0; k < 200; ++k) {
    const double middle = std::sqrt(low * high);
    (across(middle) > 0 ? high : low) = middle;
  }
  const double l3 = std::sqrt(low * high), log_volume = std::log(l1 * l2 * l3);
  return (l1 * l1 + l2 * l2 + l3 * l3 - 3) / 2 - log_volume + lambda / 2 * log_volume * log_volume;
}

}  // namespace vasorod
