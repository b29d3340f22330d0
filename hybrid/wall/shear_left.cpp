#include "wall/shear_left.h"

#include <cmath>

#include "wall/ring_softness.h"

namespace vasorod {

double shear_left(const Eigen::Matrix<double, 2, 3>& gradients, const WallSection& section,
                  const Vec2& d) {
  const double t = section.outer - section.inner;
  const Mat3 bending = std::pow(t, 3) / 12 * section.stiffness;
  const Vec3 unit(d[0] * d[0], d[1] * d[1], 2 * d[0] * d[1]);
  const double shear = shear_factor * t * d.cwiseAbs2().dot(section.shear_modulus);
  constexpr double wave = 1;
  return 1 - ring_softness(gradients, bending, d, wave / 2) * shear / unit.dot(bending * unit);
}

}  // namespace vasorod
