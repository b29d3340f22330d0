// What the softness of the triangles leaves of a wall's shear across its thickness.
//
// Mid-edge bending of wave number k has the stiffness D (1 - c k^2) (ring_softness.h); a wall that
// shears has D (1 - D k^2 / S). On coarse triangles a wall that does not shear therefore bends
// beside a rim as if it did. A lean (leaning_triangle.h) must add only the share
//
//   1 - c S / D,   c ~ h^2 / 7,   D / S ~ 0.29 t^2 where isotropic with nu = 0.3
#pragma once

#include <vasorod/types.h>

#include "wall/wall_section.h"

namespace vasorod {

/// The share of the compliance 1 / S along the unit direction d; not positive where the triangle is
/// softer than the wall. `gradients`: of the barycentric coordinates, 1/length.
double shear_left(const Eigen::Matrix<double, 2, 3>& gradients, const WallSection& section,
                  const Vec2& d);

/// 5/6 in S = 5/6 G t.
inline constexpr double shear_factor = 5.0 / 6;

}  // namespace vasorod
