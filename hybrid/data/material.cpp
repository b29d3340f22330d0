#include <cmath>

#include <vasorod/error.h>
#include <vasorod/material.h>

#include "data/sentence.h"

namespace vasorod {

std::string to_string(Law law) {
  return law == Law::biot ? "biot" : "svk";
}

Material Material::isotropic(double young, double poisson, Law law) {
  return {law, young, young, young / (2 * (1 + poisson)), poisson, poisson};
}

bool Material::is_isotropic() const {
  const Material like = isotropic(young_axial, poisson_tt);
  return young_transverse == like.young_transverse && shear_axial == like.shear_axial &&
         poisson_lt == like.poisson_lt;
}

std::optional<MaterialFault> fault_of(const Material& m) {
  for (const auto& [name, modulus] :
       {std::pair{"E_axial", m.young_axial}, std::pair{"E_T", m.young_transverse},
        std::pair{"G_axial", m.shear_axial}})
    if (!(modulus > 0) || !std::isfinite(modulus))
      return MaterialFault{name + (" = " + number_text(modulus)), "a finite number above 0"};
  if (!(std::abs(m.poisson_tt) < 1))
    return MaterialFault{"nu_TT = " + number_text(m.poisson_tt),
                         "-1 < nu_TT < 1, or the wall has no positive energy"};
  const double left =
      1 - m.poisson_tt - 2 * m.poisson_lt * m.poisson_lt * m.young_transverse / m.young_axial;
  constexpr double rounding = 1e-12;  // of an incompressible wall's zero
  if (!(left > -rounding))
    return MaterialFault{"1 - nu_TT - 2 nu_LT^2 E_T/E_L = " + number_text(left),
                         "a number that is not negative, or the wall has no positive energy"};
  return std::nullopt;
}

void check_material(const Material& material, const std::string& where) {
  if (const auto fault = fault_of(material))
    throw InputError(where + ": found " + fault->found + ", expected " + fault->expected);
}

}  // namespace vasorod
