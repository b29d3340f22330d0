#include <cmath>

#include <vasorod/error.h>
#include <vasorod/material.h>

#include "data/sentence.h"

namespace vasorod {

std::string to_string(Law law) {
  switch (law) {
    case Law::biot:
      return "biot";
    case Law::svk:
      return "svk";
    case Law::neo_hookean:
      return "neo-hookean";
  }
  return {};
}

Material Material::isotropic(double young, double poisson, Law law) {
  return {law, young, young, young / (2 * (1 + poisson)), poisson, poisson};
}

namespace {

// Isotropic but for the rounding of other units.
bool nearly_isotropic(const Material& m) {
  constexpr double rounding = 1e-9;
  const Material like = Material::isotropic(m.young_axial, m.poisson_tt);
  return std::abs(m.young_transverse - like.young_transverse) <= rounding * m.young_axial &&
         std::abs(m.shear_axial - like.shear_axial) <= rounding * m.shear_axial &&
         std::abs(m.poisson_lt - like.poisson_lt) <= rounding;
}

}  // namespace

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
  if (m.law == Law::neo_hookean) {
    if (!nearly_isotropic(m))
      return MaterialFault{"neo-hookean on a transversely isotropic wall",
                           "biot or svk, as the neo-Hookean law is isotropic"};
    if (!(m.poisson_tt >= 0))  // with lambda < 0 a collapse would set free energy without bound
      return MaterialFault{"neo-hookean with nu = " + number_text(m.poisson_tt),
                           "0 <= nu <= 0.5 with this law, or biot or svk"};
  }
  return std::nullopt;
}

void check_material(const Material& material, const std::string& where) {
  if (const auto fault = fault_of(material))
    throw InputError(where + ": found " + fault->found + ", expected " + fault->expected);
}

}  // namespace vasorod
