#include "geometry/normals_on_demand.h"

#include "data/index.h"

namespace vasorod {

NormalsOnDemand::NormalsOnDemand(const ClosestPoint& surface)
    : surface_(surface),
      normals_(surface.surface().points.rows(), 3),
      known_(index(surface.surface().points.rows()), 0) {}

Vec3 NormalsOnDemand::operator()(int vertex) {
  if (!known_[index(vertex)]) {
    normals_.row(vertex) = surface_.vertex_normal(vertex);
    known_[index(vertex)] = 1;
  }
  return normals_.row(vertex);
}

}  // namespace vasorod
