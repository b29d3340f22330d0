#include "geometry/ray_hits.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <tuple>

#include "data/index.h"
#include "geometry/box_tree.h"

namespace vasorod {
namespace {

// Exact predicates: whether a ray hits is decided without rounding.
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Triangle3 = Kernel::Triangle_3;

// Whether a ray may pass through a box, by the distances at which it passes the box's faces. Boxes
// are taken so much larger that rounding loses none.
class RayAndBox {
 public:
  RayAndBox(const Vec3& origin, const Vec3& direction, double farthest, double extent)
      : origin_(origin),
        inverse_(direction.cwiseInverse()),
        farthest_(farthest),
        slack_(1e-12 * (extent + origin.cwiseAbs().maxCoeff())) {}

  bool operator()(const Box& box) const {
    double from = -slack_, to = farthest_ + slack_;
    for (int c = 0; c < 3; ++c) {
      const double low = box.low[c] - slack_ - origin_[c], high = box.high[c] + slack_ - origin_[c];
      if (!std::isfinite(inverse_[c])) {
        if (low > 0 || high < 0) return false;
        continue;
      }
      const double a = low * inverse_[c], b = high * inverse_[c];
      from = std::max(from, std::min(a, b));
      to = std::min(to, std::max(a, b));
    }
    return from <= to;
  }

 private:
  Vec3 origin_, inverse_;
  double farthest_, slack_;
};

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
    corners.reserve(index(triangles.rows()));
    normals.resize(triangles.rows(), 3);
    for (int t = 0; t < triangles.rows(); ++t) {
      corners.emplace_back(corner(t, 0), corner(t, 1), corner(t, 2));
      const Vec3 a = points.row(triangles(t, 0)), b = points.row(triangles(t, 1)),
                 c = points.row(triangles(t, 2));
      normals.row(t) = (b - a).cross(c - a).transpose();
    }
    boxes = BoxTree(triangle_boxes({points, triangles}));
    extent = points.rows() > 0 ? points.cwiseAbs().maxCoeff() : 0;
  }

  Triangles triangles;
  std::vector<Triangle3> corners;
  Points normals;  // twice the area long
  BoxTree boxes;
  double extent = 0;  // the largest coordinate
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
  // Walls that a solver has lost may be anywhere, or so far away that rounding takes the whole way.
  const Vec3 to = origin + (std::isfinite(farthest) ? farthest : 1) * direction;
  if (!origin.allFinite() || !to.allFinite() || to == origin) return;
  const Kernel::Point_3 from(origin.x(), origin.y(), origin.z());
  const RayAndBox touches(origin, direction, farthest, tree_->extent);
  const auto search = [&](const auto& line) {
    tree_->boxes.visit(touches, [&](int t) {
      const Triangle3& corner = tree_->corners[index(t)];
      const Vec3 normal = tree_->normals.row(t);
      const double steepness = normal.dot(direction);
      // CGAL asks for triangles with an area, and for numbers that are finite.
      if (steepness == 0 || !std::isfinite(steepness) || corner.is_degenerate()) return;
      if (!CGAL::do_intersect(line, corner)) return;
      const auto& p = corner.vertex(0);
      const double distance = normal.dot(Vec3(p.x(), p.y(), p.z()) - origin) / steepness;
      hits.push_back({t, distance, steepness > 0});
    });
  };
  if (std::isfinite(farthest)) {
    search(Kernel::Segment_3(from, Kernel::Point_3(to.x(), to.y(), to.z())));
  } else {
    search(Kernel::Ray_3(from, Kernel::Vector_3(direction.x(), direction.y(), direction.z())));
  }
  std::sort(hits.begin(), hits.end(), [](const RayHit& a, const RayHit& b) {
    return std::tie(a.distance, a.triangle) < std::tie(b.distance, b.triangle);
  });
}

}  // namespace vasorod
