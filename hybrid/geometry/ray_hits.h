// Where a ray passes through the triangles of a surface.
#pragma once

#include <limits>
#include <memory>
#include <vector>

#include <vasorod/types.h>

namespace vasorod {

/// One triangle that a ray passes through.
struct RayHit {
  int triangle = -1;    ///< index of the triangle
  double distance = 0;  ///< from the ray's origin, length
  bool leaves = false;  ///< whether the ray passes to the side of the triangle's normal
};

/// A tree of boxes over a surface's triangles, which CGAL's exact predicates then ask. Copies what
/// it needs of the surface.
class RayHits {
 public:
  explicit RayHits(const TriangleSurface& surface);
  RayHits(RayHits&&) noexcept;
  RayHits& operator=(RayHits&&) noexcept;
  ~RayHits();

  /// Moves the points (n x 3, as many as before); the triangles stay the same.
  void refit(const Points& points);

  /// All hits of the ray from `origin` in the unit `direction` up to `farthest` (length), from near
  /// to far. A ray through an edge may hit both its triangles; one parallel to a triangle does not
  /// hit it.
  std::vector<RayHit> along(const Vec3& origin, const Vec3& direction,
                            double farthest = std::numeric_limits<double>::infinity()) const;
  /// The same into `hits`, whose storage is used again.
  void along(const Vec3& origin, const Vec3& direction, double farthest,
             std::vector<RayHit>& hits) const;
  /// The same of a ray from a vertex of the surface, whose own triangles are left out.
  void along_from(int vertex, const Vec3& direction, double farthest,
                  std::vector<RayHit>& hits) const;

 private:
  template <class LeavesOut>
  void find(const Vec3& origin, const Vec3& direction, double farthest, LeavesOut leaves_out,
            std::vector<RayHit>& hits) const;

  struct Tree;
  std::unique_ptr<Tree> tree_;
};

}  // namespace vasorod
