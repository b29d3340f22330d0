#include "wall/held_thickness.h"

#include <cmath>

namespace vasorod {

Mat3 held_thickness(const Material& material, double thickness, const Vec2& d) {
  const Mat3 plane = plane_stress(material);
  const Vec3 thinning = material.poisson_lt / material.young_axial * plane.col(0) +
                        material.poisson_tt / material.young_transverse * plane.col(1);
  const Vec3 across(d[0] * d[0], d[1] * d[1], 2 * d[0] * d[1]);
  const double contraction = thinning.dot(across), modulus = across.dot(plane * across),
               shear = d.cwiseAbs2().dot(transverse_shear(material)) / ordinary_shear(material);
  return std::sqrt(shear) * (0.146 - 0.031 * contraction) * modulus * thickness * thickness *
         thinning * thinning.transpose();
}

}  // namespace vasorod
