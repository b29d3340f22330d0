// What a vertex of a wall faces: the wall's other parts along its normal, and whether the space
// between them is inside out.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "geometry/ray_hits.h"

namespace vasorod {

/// A part of the wall on the ray from one of its vertices.
struct FacingWall {
  int triangle = -1;  ///< -1: none
  std::array<int, 3> corner{};
  Vec3 weight = Vec3::Zero();  ///< of the corners, where the ray hits
  Vec3 at = Vec3::Zero();      ///< that point
  Vec3 normal = Vec3::Zero();  ///< outward there, unit
};

/// Rays from the vertices of one surface, its open ends closed by lids.
class FacingWalls {
 public:
  explicit FacingWalls(const TriangleSurface& surface);

  /// Moves the points (n x 3, as many as before).
  void refit(const Points& points);

  const Points& normals() const { return normals_; }

  /// The first wall along the ray from `vertex`, outwards or inwards, up to `farthest` (length),
  /// that faces it, but for the triangles of the vertex. `skip(corner)`: leaves out a wall
  /// altogether. `seen`: distance to the first wall that is not left out, whichever way it faces;
  /// `farthest` where there is none.
  template <class Skip>
  FacingWall first(int vertex, bool outside, double farthest, const Skip& skip, double& seen) const;

  /// How often the surface winds around the space just outside the vertex: 0 as it should be, 1
  /// where it lies inside another part, -1 where opposite walls of the lumen have passed through
  /// each other, so that the space between them is inside out.
  int winding_outside(int vertex) const;

 private:
  std::array<int, 3> corners_of(int triangle) const;
  FacingWall wall_at(int triangle, const Vec3& at) const;
  bool faces(const FacingWall& wall, const Vec3& normal) const;

  TriangleSurface now_;
  std::vector<std::vector<int>> loops_;  // of the open ends
  TriangleSurface closed_;               // now_, then the lids: a point and a fan for each
  Points normals_;
  RayHits rays_;
  mutable std::vector<RayHit> hits_;
};

template <class Skip>
FacingWall FacingWalls::first(int vertex, bool outside, double farthest, const Skip& skip,
                              double& seen) const {
  const Vec3 from = now_.points.row(vertex), normal = normals_.row(vertex);
  const Vec3 direction = outside ? normal : Vec3(-normal);
  seen = farthest;
  rays_.along_from(vertex, direction, farthest, hits_);
  for (const RayHit& hit : hits_) {
    if (hit.triangle >= now_.triangles.rows() || skip(corners_of(hit.triangle))) continue;
    seen = std::min(seen, hit.distance);
    FacingWall wall = wall_at(hit.triangle, from + hit.distance * direction);
    if (faces(wall, normal)) return wall;
  }
  return {};
}

}  // namespace vasorod
