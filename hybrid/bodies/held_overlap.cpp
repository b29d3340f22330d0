#include "bodies/held_overlap.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "geometry/closest_point.h"
#include "geometry/normals_on_demand.h"
#include "geometry/triangle_surface.h"

namespace vasorod {
namespace {

// The wall of one body in one configuration, for distance queries.
class Wall {
 public:
  Wall(const Triangles& triangles, const Points& points, const std::vector<char>& fixed)
      : triangles_(triangles),
        points_(points),
        normal_of_({points, triangles}),
        closest_(TriangleSurface{points, triangles}) {
    for (const Edge& e : edges_of(triangles))
      if (e.boundary() && fixed[static_cast<size_t>(e.a)] && fixed[static_cast<size_t>(e.b)])
        held_.emplace_back(e.a, e.b);
  }

  struct Place {
    double height = 0;  // over the wall, length
    Vec3 normal = Vec3::Zero();
    double along = 0;  // distance along the wall to the nearest held edge
    int vertex = -1;   // of that edge
  };
  Place of(const Vec3& p) {
    const ClosestPoint::Hit hit = closest_.query(p);
    Place place;
    for (int k = 0; k < 3; ++k)
      place.normal += hit.barycentric[k] * normal_of_(triangles_(hit.triangle, k));
    place.normal.normalize();
    place.height = place.normal.dot(p - hit.point);
    place.along = std::numeric_limits<double>::infinity();
    for (const auto& [a, b] : held_) {
      const Vec3 start = points_.row(a), edge = points_.row(b).transpose() - start;
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
  const Triangles& triangles_;
  const Points& points_;
  NormalsOnDemand normal_of_;
  ClosestPoint closest_;
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
    Wall now(to.rest.triangles, to.carried, to.fixed);
    std::optional<Wall> rest;
    NormalsOnDemand normal_of({from.carried, from.rest.triangles});
    const double offsets = from.offset + to.offset;
    for (size_t i = 0; i < from.fixed.size(); ++i) {
      if (!from.fixed[i]) continue;
      const auto row = static_cast<Eigen::Index>(i);
      const Wall::Place at = now.of(from.carried.row(row));
      if (offsets - at.height <= at.along) continue;  // an overlap at rest only takes from it
      if (!rest) rest.emplace(to.rest.triangles, to.rest.points, to.fixed);
      const double before = std::min(0.0, rest->of(from.rest.points.row(row)).height - offsets);
      const double depth = before - (at.height - offsets);
      // Walls that face the same way do not touch, e.g. the end of a vessel within a wider one.
      if (depth <= at.along || at.normal.dot(normal_of(static_cast<int>(i))) > 0) continue;
      mine.push_back(static_cast<int>(i));
      other.push_back(at.vertex);
      overlap.depth = std::max(overlap.depth, depth);
    }
  };
  search(a, b, overlap.in_a, overlap.in_b);
  search(b, a, overlap.in_b, overlap.in_a);
  return overlap;
}

}  // namespace vasorod
