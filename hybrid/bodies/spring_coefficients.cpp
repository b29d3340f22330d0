#include "bodies/spring_coefficients.h"

#include <cmath>

namespace vasorod {

Coefficients coefficients_from_wall(const Material& material, const WallGeometry& wall) {
  const double membrane = material.young_axial * wall.thickness;
  const double nu = material.poisson_tt;
  const double plate = membrane * wall.thickness * wall.thickness / (12 * (1 - nu * nu));
  const double root3 = std::sqrt(3.0);
  return {.binding = 0.01 * membrane / (wall.radius * wall.radius) * wall.vertex_area,
          .bending = 4 * root3 * plate / (wall.mean_edge * wall.mean_edge),
          .stretching = root3 / 4 * membrane};
}

}  // namespace vasorod
