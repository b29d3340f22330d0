#include "rod/lumen_section.h"

#include <numbers>

#include "geometry/rigid_motion.h"

namespace vasorod {

// In plane strain the section has the moduli E' and nu' of
//   e_hoop = (s_hoop - nu' s_radial) / E'
// and Lame's stresses p a^2 / (b^2 - a^2) (1 -+ b^2 / r^2).
double hoop_strain_per_pressure(const AnnularSection& section, const Material& material, double r) {
  const double across = material.poisson_lt * material.young_transverse / material.young_axial,
               young = material.young_transverse / (1 - across * material.poisson_lt),
               poisson = (material.poisson_tt + across * material.poisson_lt) /
                         (1 - across * material.poisson_lt);
  const double a2 = section.inner() * section.inner(), b2 = section.outer() * section.outer();
  return a2 / (b2 - a2) * ((1 - poisson) + (1 + poisson) * b2 / (r * r)) / young;
}

LumenSection lumen_section(const AnnularSection& section, const Material& material, double scan,
                           double pressure) {
  LumenSection now;
  const double inner = section.inner(), change = pressure - scan;
  now.inner_strain = inner > 0 ? change * hoop_strain_per_pressure(section, material, inner) : 0;
  now.mid_strain = change * hoop_strain_per_pressure(section, material, section.radius);
  const double wider = 1 + now.inner_strain, area = std::numbers::pi * inner * inner;
  now.area = area * wider * wider;
  now.thrust = pressure * area * wider * (wider - 2 * material.poisson_lt);
  return now;
}

Vec6 unit_thrust(const RodElement& element, bool at_fork) {
  if (!at_fork) return Vec6::Unit(2);
  const Mat6 turned = right_jacobian(Vec6(element.length * element.rest_strain));
  return turned.transpose() * Vec6::Unit(2);
}

}  // namespace vasorod
