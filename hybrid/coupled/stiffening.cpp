#include "coupled/stiffening.h"

#include <algorithm>

namespace vasorod {
namespace {

// Up to this ratio a wall's path can be followed. From larger ones the steps to its own shear
// modulus end in minima that rounding leaves undecided.
constexpr double followed_ratio = 2000;
// From one minimum to the next; with less the steps cost more.
constexpr double growth = 30;

// Of the moduli, over that of an isotropic wall: at a thousandth of it walls converge.
constexpr double largest_felt_ratio = 1e10;

}  // namespace

double shear_ratio(const Material& material) {
  const double young = std::max(material.young_axial, material.young_transverse);
  return material.shear_axial * 2 * (1 + material.poisson_tt) / young;
}

bool hides_forces(const Material& material) {
  const double ratio = shear_ratio(material);
  return std::max(ratio, 1 / ratio) > largest_felt_ratio;
}

Material eased(const Material& own) {
  Material eased = own;
  eased.shear_axial *= std::min(1.0, followed_ratio / shear_ratio(own));
  return eased;
}

Material stiffened(const Material& now, const Material& own) {
  Material next = now;
  next.shear_axial = std::min(own.shear_axial, growth * now.shear_axial);
  return next;
}

}  // namespace vasorod
