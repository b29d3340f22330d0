#include "wall/plane_stress.h"

#include <cmath>

namespace vasorod {

Vec2 transverse_shear(const Material& m) {
  return {m.shear_axial, m.young_transverse / (2 * (1 + m.poisson_tt))};
}

double ordinary_shear(const Material& m) {
  const double poisson = m.poisson_lt * std::sqrt(m.young_transverse / m.young_axial);
  return std::sqrt(m.young_axial * m.young_transverse) / (2 * (1 + poisson));
}

Mat3 plane_stress(const Material& m) {
  // S11 = 1/E_L, S22 = 1/E_T, S12 = -nu_LT/E_L, inverted.
  const double nu_tl = m.poisson_lt * m.young_transverse / m.young_axial;
  const double factor = 1 / (1 - m.poisson_lt * nu_tl);
  Mat3 c = Mat3::Zero();
  c(0, 0) = factor * m.young_axial;
  c(1, 1) = factor * m.young_transverse;
  c(0, 1) = c(1, 0) = factor * m.poisson_lt * m.young_transverse;
  c(2, 2) = m.shear_axial;
  return c;
}

}  // namespace vasorod
