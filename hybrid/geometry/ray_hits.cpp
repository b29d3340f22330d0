#include "geometry/ray_hits.h"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <Eigen/Geometry>
#include <algorithm>
#include <boost/iterator/function_output_iterator.hpp>
#include <cmath>
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
  explicit Tree(const TriangleSurface& surface) : triangles(surface.triangles) {
    rebuild(surface.points);
  }

  void rebuild(const Points& points) {
    const auto corner = [&](int t, int k) {
      const auto p = points.row(triangles(t, k));
      return Kernel::Point_3(p.x(), p.y(), p.z());
    };
    corners.clear();
    corners.reserve(static_cast<std::size_t>(triangles.rows()));
    normals.resize(triangles.rows(), 3);
    for (int t = 0; t < triangles.rows(); ++t) {
      corners.emplace_back(corner(t, 0), corner(t, 1), corner(t, 2));
      const Vec3 a = points.row(triangles(t, 0)), b = points.row(triangles(t, 1)),
                 c = points.row(triangles(t, 2));
      normals.row(t) = (b - a).cross(c - a).transpose();
    }
    tree.clear();
    tree.insert(corners.cbegin(), corners.cend());
    tree.build();
  }

  Triangles triangles;
  Corners corners;
  Points normals;  // twice the area long
  AabbTree tree;
};

RayHits::RayHits(const TriangleSurface& surface) : tree_(std::make_unique<Tree>(surface)) {}
RayHits::RayHits(RayHits&&) noexcept = default;
RayHits& RayHits::operator=(RayHits&&) noexcept = default;
RayHits::~RayHits() = default;

void RayHits::refit(const Points& points) {
  tree_->rebuild(points);
}

std::vector<RayHit> RayHits::along(const Vec3& origin, const Vec3& direction,
                                   double farthest) const {
  std::vector<RayHit> hits;
  along(origin, direction, farthest, hits);
  return hits;
}

void RayHits::along(const Vec3& origin, const Vec3& direction, double farthest,
                    std::vector<RayHit>& hits) const {
  hits.clear();
  const Kernel::Point_3 from(origin.x(), origin.y(), origin.z());
  const auto take = boost::make_function_output_iterator([&](Corners::const_iterator corner) {
    const auto t = corner - tree_->corners.cbegin();
    const Vec3 normal = tree_->normals.row(t);
    const double steepness = normal.dot(direction);
    if (steepness == 0) return;
    const auto& p = corner->vertex(0);
    const double distance = normal.dot(Vec3(p.x(), p.y(), p.z()) - origin) / steepness;
    hits.push_back({static_cast<int>(t), distance, steepness > 0});
  });
  if (std::isfinite(farthest)) {
    const Vec3 to = origin + farthest * direction;
    tree_->tree.all_intersected_primitives(
        Kernel::Segment_3(from, Kernel::Point_3(to.x(), to.y(), to.z())), take);
  } else {
    const Kernel::Vector_3 way(direction.x(), direction.y(), direction.z());
    tree_->tree.all_intersected_primitives(Kernel::Ray_3(from, way), take);
  }
  std::sort(hits.begin(), hits.end(), [](const RayHit& a, const RayHit& b) {
    return std::tie(a.distance, a.triangle) < std::tie(b.distance, b.triangle);
  });
}

}  // namespace vasorod
