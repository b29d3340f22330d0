#include "geometry/normals_on_demand.h"

#include <algorithm>
#include <numeric>

#include "data/index.h"
#include "geometry/triangle_surface.h"

namespace vasorod {

TrianglesAround::TrianglesAround(const Triangles& triangles, Eigen::Index vertices)
    : first_(index(vertices) + 1, 0), triangle_(index(triangles.size())) {
  for (Eigen::Index t = 0; t < triangles.rows(); ++t)
    for (int k = 0; k < 3; ++k) ++first_[index(triangles(t, k)) + 1];
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  std::vector<int> next(first_.begin(), first_.end() - 1);
  for (int t = 0; t < triangles.rows(); ++t)
    for (int k = 0; k < 3; ++k) triangle_[index(next[index(triangles(t, k))]++)] = t;
}

Vec3 TrianglesAround::normal(const TriangleSurface& surface, int vertex) const {
  Vec3 sum = Vec3::Zero();
  for (int i = first_[index(vertex)]; i < first_[index(vertex) + 1]; ++i) {
    const int triangle = triangle_[index(i)];
    const Vec3 normal = triangle_normal(surface, triangle);
    const double twice_area = normal.norm();
    for (int k = 0; k < 3 && twice_area > 0; ++k)
      if (surface.triangles(triangle, k) == vertex)
        sum += corner_angle(surface, triangle, k, twice_area) / twice_area * normal;
  }
  const double length = sum.norm();
  if (length > 0) sum /= length;
  return sum;
}

NormalsOnDemand::NormalsOnDemand(const TriangleSurface& surface)
    : surface_(surface),
      around_(surface.triangles, surface.points.rows()),
      normals_(surface.points.rows(), 3),
      known_(index(surface.points.rows()), 0) {}

void NormalsOnDemand::move(const Points& points) {
  surface_.points = points;
  std::fill(known_.begin(), known_.end(), 0);
}

Vec3 NormalsOnDemand::operator()(int vertex) {
  if (!known_[index(vertex)]) {
    normals_.row(vertex) = around_.normal(surface_, vertex);
    known_[index(vertex)] = 1;
  }
  return normals_.row(vertex);
}

}  // namespace vasorod
