#include "surface/coefficients.h"

#include <cmath>

namespace vasorod {

PaperCoefficients coefficients_from_wall(const WallAndMesh& wall) {
  const double membrane = wall.young * wall.thickness;
  const double plate = membrane * wall.thickness * wall.thickness / (12 * (1 - wall.poisson * wall.poisson));
  const double root3 = std::sqrt(3.0);
  return {.binding = 0.01 * membrane / (wall.radius * wall.radius) * wall.vertex_area,
          .bending = 4 * root3 * plate / (wall.mean_edge * wall.mean_edge),
          .stretching = root3 / 4 * membrane};
}

}  // namespace vasorod
