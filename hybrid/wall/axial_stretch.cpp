#include "wall/axial_stretch.h"

#include "wall/plane_stress.h"

namespace vasorod {

Vec3 strain_of_stretch(const Material& material, double stretch) {
  const Mat3 c = plane_stress(material);
  return {stretch - 1, -c(0, 1) / c(1, 1) * (stretch - 1), 0};
}

}  // namespace vasorod
