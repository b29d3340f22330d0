// Closest point of a triangle surface, with the signed distance of the query point.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include <vasorod/types.h>

namespace vasorod {

/// Answers closest-point queries on one surface. The sign comes from the angle-weighted
/// pseudo-normal of the closest feature: face, edge or vertex (Baerentzen and Aanaes 2005). The
/// sign is exact on a closed surface. On an open vessel, a hit with `on_boundary` lies on the rim
/// of an end, and its sign has no meaning.
class ClosestPoint {
 public:
  /// The closest point of one query.
  struct Hit {
    Vec3 point = Vec3::Zero();  ///< on the surface, length unit
    int triangle = -1;          ///< row of the surface's triangles
    /// Barycentric coordinates of `point` in the triangle; sum 1, exact zeros on edges.
    Vec3 barycentric = Vec3::Zero();
    double signed_distance = 0;  ///< length unit, positive outside
    Vec3 normal = Vec3::Zero();  ///< unit pseudo-normal of the closest feature, outwards
    bool on_boundary = false;    ///< the closest feature is a boundary edge or a boundary vertex
  };

  /// Throws InputError if the surface has no triangles or an edge with three triangles.
  explicit ClosestPoint(const TriangleSurface& surface);
  ~ClosestPoint();
  ClosestPoint(ClosestPoint&&) noexcept;
  ClosestPoint& operator=(ClosestPoint&&) noexcept;

  /// The closest point to `point`. `near`: a triangle near it, from which the search is shorter, or
  /// -1; the answer does not depend on it. Thread-safe.
  Hit query(const Vec3& point, int near = -1) const;

  /// Moves the points (n x 3, as many as before); the triangles stay the same. The first query
  /// after it takes longer.
  void refit(const Points& points);
  /// The same triangles with their points there (n x 3), for the price of the points.
  ClosestPoint moved(const Points& points) const;

  const TriangleSurface& surface() const;  ///< where it is now
  /// That vertex's row of vertex_normals(), bit for bit.
  Vec3 vertex_normal(int vertex) const;
  /// The edges with one triangle, sorted, each with its lower vertex first.
  std::vector<std::array<int, 2>> boundary_edges() const;

 private:
  struct Links;
  struct Tree;
  explicit ClosestPoint(std::unique_ptr<Tree> tree);
  std::unique_ptr<Tree> tree_;
};

/// The closest point to a single `point`: as ClosestPoint::query(), without the tree that pays off
/// for many. Throws InputError as ClosestPoint does, of non-manifold edges only near the point.
ClosestPoint::Hit closest_on(const TriangleSurface& surface, const Vec3& point);

/// Barycentric coordinates of the point of triangle (a, b, c) closest to p. Never NaN, also for
/// degenerate triangles (Ericson 2005, section 5.1.5).
Vec3 closest_in_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c);

}  // namespace vasorod
