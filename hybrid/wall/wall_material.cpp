#include "wall/wall_material.h"

#include <cmath>
#include <sstream>

#include "geometry/error.h"

namespace vasorod {

WallMaterial WallMaterial::isotropic(double young, double poisson, StrainLaw law) {
  return {law, young, young, young / (2 * (1 + poisson)), poisson, poisson};
}

void check_material(const WallMaterial& m, const std::string& where) {
  const auto refuse = [&](const std::string& what, double found, const std::string& expected) {
    std::ostringstream sentence;
    sentence << where << ": " << what << " = " << found << ", expected " << expected;
    throw InputError(sentence.str());
  };
  const auto positive = [&](const char* what, double modulus) {
    if (!(modulus > 0) || !std::isfinite(modulus)) refuse(what, modulus, "a positive number");
  };
  positive("E_axial", m.young_axial);
  positive("E_T", m.young_transverse);
  positive("G_axial", m.shear_axial);
  if (!(std::abs(m.poisson_tt) < 1)) refuse("nu_TT", m.poisson_tt, "a number between -1 and 1");
  const double left = 1 - m.poisson_tt - 2 * m.poisson_lt * m.poisson_lt * m.young_transverse / m.young_axial;
  if (!(left > -1e-12))
    refuse("1 - nu_TT - 2 nu_LT^2 E_T/E_L", left,
           "a number that is not negative, or the wall has no positive energy");
}

double ordinary_shear(const WallMaterial& m) {
  const double poisson = m.poisson_lt * std::sqrt(m.young_transverse / m.young_axial);
  return std::sqrt(m.young_axial * m.young_transverse) / (2 * (1 + poisson));
}

Mat3 plane_stress(const WallMaterial& m) {
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
