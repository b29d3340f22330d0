#include "judge/triangle_strain.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace vasorod {

double triangle_strain(const Points& rest, const Points& current,
                       const std::array<int, 3>& corner) {
  const auto side = [&](const Points& points, int k) {
    return Vec3(points.row(corner[static_cast<size_t>(k)]) - points.row(corner[0]));
  };
  const Vec3 a = side(rest, 1), b = side(rest, 2), c = side(current, 1), d = side(current, 2);
  const double area = a.cross(b).norm();
  if (!(area > 0)) return std::numeric_limits<double>::infinity();
  // F on an orthonormal frame of the plane at rest: (1, 0) along a.
  const double along = a.norm(), b1 = a.dot(b) / along, b2 = area / along;
  const Vec3 f1 = c / along, f2 = (d - b1 * f1) / b2;
  // The eigenvalues of F^T F are the squares of the stretches.
  const double mean = (f1.squaredNorm() + f2.squaredNorm()) / 2,
               half = std::hypot((f1.squaredNorm() - f2.squaredNorm()) / 2, f1.dot(f2));
  const double least = std::sqrt(std::max(0.0, mean - half)), most = std::sqrt(mean + half);
  return std::max(1 - least, most - 1);
}

}  // namespace vasorod
