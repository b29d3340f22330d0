// The foot of a point p on a surface along the surface's interpolated normals (Panozzo et al. 2013,
// "Phong projection"): y in one triangle with
//
//   y = sum_k b_k x_k,   p = y + d sum_k b_k n_k,   n_k the vertex normals.
//
// The closest point of a triangle mesh jumps where p passes over a concave edge, by about the
// height times the fold angle, and stays on the edge where p passes over a convex one. The foot
// moves continuously with p as long as d times the curvature of the surface is below 1.
#pragma once

#include "geometry/closest_point.h"
#include "geometry/normals_on_demand.h"

namespace vasorod {

/// The foot of a point.
struct NormalFoot {
  int triangle = -1;
  Vec3 weight = Vec3::Zero();  ///< b, sum 1
  Vec3 normal = Vec3::Zero();  ///< sum b_k n_k, not normalised
  double height = 0;           ///< d, length, positive outside
};

/// The foot near `closest`, the closest point of p on the surface of `finder`. If no nearby normal
/// reaches p, in a crease or beyond an open rim, the closest point itself is returned.
NormalFoot normal_foot(const ClosestPoint& finder, NormalsOnDemand& normal_of, const Vec3& p,
                       const ClosestPoint::Hit& closest);

}  // namespace vasorod
