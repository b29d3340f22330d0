// Hutchinson's (2001) shear coefficient of a hollow circle.
#pragma once

namespace vasorod::fem {

inline double hutchinson(double inner, double outer, double nu) {
  const double a2 = outer * outer, b2 = inner * inner, a4 = a2 * a2 + b2 * b2, ab = a2 * b2;
  return 6 * (a2 + b2) * (a2 + b2) * (1 + nu) * (1 + nu) /
         (7 * a4 + 34 * ab + nu * (12 * a4 + 48 * ab) + nu * nu * (4 * a4 + 16 * ab));
}

}  // namespace vasorod::fem
