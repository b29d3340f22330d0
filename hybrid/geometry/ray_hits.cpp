#include "geometry/ray_hits.h"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <tuple>

namespace vasorod {
namespace {

// Exact predicates: whether a ray hits is decided without rounding.
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Triangle3 = Kernel::Triangle_3;
using Corners = std::vector<Triangle3>;
using Primitive = CGAL::AABB_triangle_primitive<Kernel, Corners::const_iterator>;
using AabbTree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;

}  // namespace

struct RayHits::Tree {
  explicit Tree(const TriangleSurface& surface) {
    const auto corner = [&](int t, int k) {
      const auto p = surface.points.row(surface.triangles(t, k));
      return Kernel::Point_3(p.x(), p.y(), p.z());
    };
    corners.reserve(static_cast<std::size_t>(surface.triangles.rows()));
    normals.resize(surface.triangles.rows(), 3);
    for (int t = 0; t < surface.triangles.rows(); ++t) {
      corners.emplace_back(corner(t, 0), corner(t, 1), corner(t, 2));
      const Vec3 a = surface.points.row(surface.triangles(t, 0)),
                 b = surface.points.row(surface.triangles(t, 1)),
                 c = surface.points.row(surface.triangles(t, 2));
      normals.row(t) = (b - a).cross(c - a).transpose();
    }
    tree.insert(corners.cbegin(), corners.cend());
    tree.build();
  }
  Corners corners;
  Points normals;  // twice the area long
  AabbTree tree;
};

RayHits::RayHits(const TriangleSurface& surface) : tree_(std::make_unique<Tree>(surface)) {}
RayHits::RayHits(RayHits&&) noexcept = default;
RayHits& RayHits::operator=(RayHits&&) noexcept = default;
RayHits::~RayHits() = default;

std::vector<RayHit> RayHits::along(const Vec3& origin, const Vec3& direction,
                                   double farthest) const {
  const Kernel::Point_3 from(origin.x(), origin.y(), origin.z());
  std::vector<Corners::const_iterator> found;
  if (std::isfinite(farthest)) {
    const Vec3 to = origin + farthest * direction;
    tree_->tree.all_intersected_primitives(
        Kernel::Segment_3(from, Kernel::Point_3(to.x(), to.y(), to.z())),
        std::back_inserter(found));
  } else {
    const Kernel::Vector_3 way(direction.x(), direction.y(), direction.z());
    tree_->tree.all_intersected_primitives(Kernel::Ray_3(from, way), std::back_inserter(found));
  }
  std::vector<RayHit> hits;
  for (const auto& corner : found) {
    const auto t = corner - tree_->corners.cbegin();
    const Vec3 normal = tree_->normals.row(t);
    const double steepness = normal.dot(direction);
    if (steepness == 0) continue;
    const auto& p = corner->vertex(0);
    const double distance = normal.dot(Vec3(p.x(), p.y(), p.z()) - origin) / steepness;
    hits.push_back({static_cast<int>(t), distance, steepness > 0});
  }
  std::sort(hits.begin(), hits.end(), [](const RayHit& a, const RayHit& b) {
    return std::tie(a.distance, a.triangle) < std::tie(b.distance, b.triangle);
  });
  return hits;
}

}  // namespace vasorod
