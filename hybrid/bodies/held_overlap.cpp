#include "bodies/held_overlap.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "geometry/normals_on_demand.h"

namespace vasorod {
namespace {

// The wall of one body in one configuration, for distance queries.
class Wall {
 public:
  Wall(const ClosestPoint& surface, const std::vector<char>& fixed)
      : surface_(surface), normal_of_(surface) {
    for (const auto& [a, b] : surface.boundary_edges())
      if (fixed[static_cast<size_t>(a)] && fixed[static_cast<size_t>(b)]) held_.emplace_back(a, b);
  }

  struct Place {
    double height = 0;  // over the wall, length
    Vec3 normal = Vec3::Zero();
    double along = 0;  // distance along the wall to the nearest held edge
    int vertex = -1;   // of that edge
  };
  Place of(const Vec3& p) {
    const ClosestPoint::Hit hit = surface_.query(p);
    Place place;
    for (int k = 0; k < 3; ++k)
      place.normal +=
          hit.barycentric[k] * normal_of_(surface_.surface().triangles(hit.triangle, k));
    place.normal.normalize();
    place.height = place.normal.dot(p - hit.point);
    place.along = std::numeric_limits<double>::infinity();
    const Points& points = surface_.surface().points;
    for (const auto& [a, b] : held_) {
      const Vec3 start = points.row(a), edge = points.row(b).transpose() - start;
      const double share = std::clamp(edge.dot(hit.point - start) / edge.squaredNorm(), 0.0, 1.0);
      const double far = (hit.point - start - share * edge).norm();
      if (far < place.along) {
        place.along = far;
        place.vertex = share < 0.5 ? a : b;
      }
    }
    place.along += (p - hit.point - place.height * place.normal).norm();
    return place;
  }

 private:
  const ClosestPoint& surface_;
  NormalsOnDemand normal_of_;
  std::vector<std::pair<int, int>> held_;
};

}  // namespace

HeldOverlap held_overlap(const HeldBody& a, const HeldBody& b) {
  HeldOverlap overlap;
  const auto search = [&](const HeldBody& from, const HeldBody& to, std::vector<int>& mine,
                          std::vector<int>& other) {
    const auto held = [](const HeldBody& body) {
      return std::find(body.fixed.begin(), body.fixed.end(), 1) != body.fixed.end();
    };
    if (!held(from) || !held(to)) return;
    Wall now(to.carried, to.fixed);
    std::optional<Wall> rest;
    const Points &carried = from.carried.surface().points, &at_rest = from.rest.surface().points;
    const double offsets = from.offset + to.offset;
    for (size_t i = 0; i < from.fixed.size(); ++i) {
      if (!from.fixed[i]) continue;
      const auto row = static_cast<Eigen::Index>(i);
      const Wall::Place at = now.of(carried.row(row));
      if (offsets - at.height <= at.along) continue;  // an overlap at rest only takes from it
      if (!rest) rest.emplace(to.rest, to.fixed);
      const double before = std::min(0.0, rest->of(at_rest.row(row)).height - offsets);
      const double depth = before - (at.height - offsets);
      // Walls that face the same way do not touch, e.g. the end of a vessel within a wider one.
      const int vertex = static_cast<int>(i);
      if (depth <= at.along || at.normal.dot(from.carried.vertex_normal(vertex)) > 0) continue;
      mine.push_back(vertex);
      other.push_back(at.vertex);
      overlap.depth = std::max(overlap.depth, depth);
    }
  };
  search(a, b, overlap.in_a, overlap.in_b);
  search(b, a, overlap.in_b, overlap.in_a);
  return overlap;
}

}  // namespace vasorod
