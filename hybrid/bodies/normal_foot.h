// Where the interpolated normals of a surface reach a point: y = sum_k b_k x_k in one triangle with
// p = y + d sum_k b_k n_k, n the vertices' normals (Panozzo et al. 2013, "Phong projection").
//
// The closest point of a triangle mesh jumps where p passes over a concave edge, by about the
// height times the fold's angle, and stays behind on a convex one. The foot moves with p while d
// times the surface's curvature is below 1.
#pragma once

#include "geometry/closest_point.h"

namespace vasorod {

struct NormalFoot {
  int triangle = -1;
  Vec3 weight = Vec3::Zero();  ///< b, sum 1
  Vec3 normal = Vec3::Zero();  ///< sum b_k n_k, not of unit length
  double height = 0;           ///< of p over y along the normal, length unit, positive outside
};

/// The foot near `closest`, the closest point of p. Where the normals near it reach p from nowhere,
/// in a crease or over an open rim, that point itself.
NormalFoot normal_foot(const ClosestPoint& finder, const TriangleSurface& surface,
                       const Points& normals, const Vec3& p, const ClosestPoint::Hit& closest);

}  // namespace vasorod
