#include "wall/axial_stretch.h"

#include <cmath>

#include "wall/plane_stress.h"

namespace vasorod {

Vec3 strain_of_stretch(const Material& material, double stretch) {
  const Mat3 c = plane_stress(material);
  return {stretch - 1, -c(0, 1) / c(1, 1) * (stretch - 1), 0};
}

Vec2 stretches_along_and_across(const Material& material, double stretch) {
  if (material.law == Law::biot)
    return Vec2::Ones() + strain_of_stretch(material, stretch).head<2>();
  return {stretch, std::pow(stretch, strain_of_stretch(material, 2)[1])};
}

}  // namespace vasorod
