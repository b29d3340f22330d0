#include "wall/fold.h"

#include <Eigen/Geometry>

#include "geometry/triangle_surface.h"

namespace vasorod {

Fold sharpest_fold(const TriangleSurface& surface) {
  const auto normal = [&](int triangle) -> Vec3 {
    const Vec3 a = surface.points.row(surface.triangles(triangle, 0)),
               b = surface.points.row(surface.triangles(triangle, 1)),
               c = surface.points.row(surface.triangles(triangle, 2));
    return (b - a).cross(c - a).normalized();
  };
  Fold sharpest;
  for (const Edge& edge : edges_of(surface.triangles)) {
    if (edge.boundary()) continue;
    const double cosine = normal(edge.triangle[0]).dot(normal(edge.triangle[1]));
    if (cosine < sharpest.cosine)
      sharpest = {cosine, 0.5 * (surface.points.row(edge.a) + surface.points.row(edge.b)).transpose()};
  }
  return sharpest;
}

}  // namespace vasorod
