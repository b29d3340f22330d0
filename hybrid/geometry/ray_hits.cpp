#include "geometry/ray_hits.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include "data/index.h"
#include "geometry/box_tree.h"
#include "geometry/triangle_surface.h"

namespace vasorod {
namespace {

// Exact predicates: whether a ray hits is decided without rounding.
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Triangle3 = Kernel::Triangle_3;

// Whether a ray may pass through a box, by the distances at which it passes the box's faces. Boxes
// are taken so much larger that rounding loses none.
class RayAndBox {
 public:
  RayAndBox(const Vec3& origin, const Vec3& direction, double farthest, double extent) {
    const double slack = 1e-12 * (extent + origin.cwiseAbs().maxCoeff());
    first_ = -slack;
    last_ = farthest + slack;
    for (int c = 0; c < 3; ++c) {
      const double inverse = 1 / direction[c];
      faces_[index(c)] = {!std::isfinite(inverse), inverse < 0, inverse, origin[c] + slack,
                          origin[c] - slack};
    }
  }

  bool operator()(const Box& box) const {
    double from = first_, to = last_;
    for (int c = 0; c < 3; ++c) {
      const Faces& faces = faces_[index(c)];
      const double low = box.low[c] - faces.low_from, high = box.high[c] - faces.high_from;
      if (faces.parallel) {
        if (low > 0 || high < 0) return false;
        continue;
      }
      from = std::max(from, (faces.backwards ? high : low) * faces.inverse);
      to = std::min(to, (faces.backwards ? low : high) * faces.inverse);
    }
    return from <= to;
  }

 private:
  // How the ray meets a box's two faces across one axis.
  struct Faces {
    bool parallel = false, backwards = false;  // backwards: the upper face first
    double inverse = 0;                        // of the direction
    double low_from = 0, high_from = 0;        // the origin, with the slack
  };
  std::array<Faces, 3> faces_;
  double first_ = 0, last_ = 0;
};

}  // namespace

struct RayHits::Tree {
  explicit Tree(const TriangleSurface& whole) : surface(whole) { rebuild(); }

  void rebuild() {
    boxes = BoxTree(triangle_boxes(surface));
    extent = surface.points.rows() > 0 ? surface.points.cwiseAbs().maxCoeff() : 0;
  }

  Triangle3 triangle(int t) const {
    const auto corner = [&](int k) {
      const auto p = surface.points.row(surface.triangles(t, k));
      return Kernel::Point_3(p.x(), p.y(), p.z());
    };
    return {corner(0), corner(1), corner(2)};
  }

  TriangleSurface surface;
  BoxTree boxes;
  double extent = 0;  // the largest coordinate
};

RayHits::RayHits(const TriangleSurface& surface) : tree_(std::make_unique<Tree>(surface)) {}
RayHits::RayHits(RayHits&&) noexcept = default;
RayHits& RayHits::operator=(RayHits&&) noexcept = default;
RayHits::~RayHits() = default;

void RayHits::refit(const Points& points) {
  tree_->surface.points = points;
  tree_->rebuild();
}

std::vector<RayHit> RayHits::along(const Vec3& origin, const Vec3& direction,
                                   double farthest) const {
  std::vector<RayHit> hits;
  along(origin, direction, farthest, hits);
  return hits;
}

void RayHits::along(const Vec3& origin, const Vec3& direction, double farthest,
                    std::vector<RayHit>& hits) const {
  find(
      origin, direction, farthest, [](int) { return false; }, hits);
}

// Those triangles begin where the ray does: exact predicates would take their longest way to it.
void RayHits::along_from(int vertex, const Vec3& direction, double farthest,
                         std::vector<RayHit>& hits) const {
  const auto has_vertex = [&](int t) {
    return (tree_->surface.triangles.row(t).array() == vertex).any();
  };
  find(tree_->surface.points.row(vertex), direction, farthest, has_vertex, hits);
}

template <class LeavesOut>
void RayHits::find(const Vec3& origin, const Vec3& direction, double farthest, LeavesOut leaves_out,
                   std::vector<RayHit>& hits) const {
  hits.clear();
  // Walls that a solver has lost may be anywhere, or so far away that rounding takes the whole way.
  const Vec3 to = origin + (std::isfinite(farthest) ? farthest : 1) * direction;
  if (!origin.allFinite() || !to.allFinite() || to == origin) return;
  const Kernel::Point_3 from(origin.x(), origin.y(), origin.z());
  const RayAndBox touches(origin, direction, farthest, tree_->extent);
  const auto search = [&](const auto& line) {
    tree_->boxes.visit(touches, [&](int t) {
      if (leaves_out(t)) return;
      const Triangle3 triangle = tree_->triangle(t);
      const Vec3 normal = triangle_normal(tree_->surface, t);
      const double steepness = normal.dot(direction);
      // CGAL asks for triangles with an area, and for numbers that are finite.
      if (steepness == 0 || !std::isfinite(steepness) || triangle.is_degenerate()) return;
      if (!CGAL::do_intersect(line, triangle)) return;
      const auto& p = triangle.vertex(0);
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
