// The closest point of a triangle surface, with the side on which the query lies.
#pragma once

#include <memory>

#include <vasorod/types.h>

namespace vasorod {

/// Answers closest-point queries on one surface. The sign comes from the angle-weighted
/// pseudo-normal of the feature (face, edge or vertex) that is closest (Baerentzen and Aanaes
/// 2005), which is exact on a closed surface; on an open vessel a hit with `on_boundary` lies on
/// the rim of an end and its sign means nothing.
class ClosestPoint {
 public:
  struct Hit {
    Vec3 point = Vec3::Zero();  ///< on the surface, length unit
    int triangle = -1;          ///< row of the surface's triangles
    Vec3 barycentric =
        Vec3::Zero();            ///< of `point` in that triangle, sums to 1, exact zeros on edges
    double signed_distance = 0;  ///< length unit, positive outside
    Vec3 normal = Vec3::Zero();  ///< unit pseudo-normal of the closest feature, outwards
    bool on_boundary = false;    ///< the closest feature is a boundary edge or a boundary vertex
  };

  /// Throws InputError when the surface has no triangles, or an edge with three.
  explicit ClosestPoint(const TriangleSurface& surface);
  ~ClosestPoint();
  ClosestPoint(ClosestPoint&&) noexcept;
  ClosestPoint& operator=(ClosestPoint&&) noexcept;

  /// Safe to call from several threads at once.
  Hit query(const Vec3& point) const;

  /// The same triangles with moved points (n x 3, as many as before).
  void refit(const Points& points);

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

/// Barycentric coordinates of the point of triangle (a, b, c) closest to p; never NaN, also where
/// the triangle is degenerate (Ericson 2005, section 5.1.5).
Vec3 closest_in_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c);

}  // namespace vasorod
