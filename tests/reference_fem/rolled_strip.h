// Exact solution of a strip (nu = 0, width 1) rolled up by an end moment: Sze 3.2's benchmark
// without the elastica's assumption of constant thickness.
//
// By the Biot law the energy per area is E / 2 [(k r - 1)^2 + (r' - 1)^2] over the depth Y, with
// the radius r(Y) and the curvature k of the middle fibre. With x = k h:
//   elastica, r = 1 / k + Y:
//     M = E I k
//   solid, r = 1 / k + sinh(k Y) / (k cosh(x / 2)), the minimum over all r:
//     M = E (sinh x - x) / (2 k^2 cosh^2(x / 2)) = E I k (1 - x^2 / 5 + ...)
//   seven-parameter shell, r = 1 / k + Y / (1 + x^2 / 12), the minimum over linear r:
//     M = E I k / (1 + x^2 / 12)^2 = E I k (1 - x^2 / 6 + ...)
// The layers press on each other (M k / depth) and the wall becomes thinner, which reduces its
// bending stiffness.
#pragma once

#include <array>
#include <cmath>
#include <numbers>

namespace vasorod::fem::reference {

/// Sze 3.2: length 12, thickness 0.1. The full moment rolls the elastica into one circle.
struct RolledStrip {
  enum class Kind { elastica, solid, shell };
  double length = 12, thickness = 0.1;

  /// M / E I of the curvature k.
  double moment(Kind kind, double k) const {
    const double x = k * thickness;
    if (kind == Kind::elastica) return k;
    if (kind == Kind::shell) return k / std::pow(1 + x * x / 12, 2);
    return 6 * (std::sinh(x) - x) / (x * x * thickness * std::pow(std::cosh(x / 2), 2));
  }

  /// -u and w of the tip's middle fibre, which is unstretched in all three models, at a fraction of
  /// the full moment.
  std::array<double, 2> tip(Kind kind, double load) const {
    const double wanted = load * 2 * std::numbers::pi / length;
    double low = 0.9 * wanted, high = 1.1 * wanted;
    for (int i = 0; i < 60; ++i) {
      const double middle = (low + high) / 2;
      (moment(kind, middle) < wanted ? low : high) = middle;
    }
    const double k = (low + high) / 2;
    return {length - std::sin(k * length) / k, (1 - std::cos(k * length)) / k};
  }
};

}  // namespace vasorod::fem::reference
