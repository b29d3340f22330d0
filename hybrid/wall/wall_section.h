// Stiffness of a wall per area of its given surface, integrated through the thickness with the curvature it
// has at rest.
#pragma once

#include "geometry/types.h"

namespace vasorod {

/// A symmetric 2 x 2 tensor as (11, 22, 12): here the rest curvature, positive where convex, 1/length.
struct WallSection {
  double inner = 0, outer = 0;  ///< the wall's faces along the outward normal, from the given surface, length
  Vec3 curvature = Vec3::Zero();  ///< b0
  Mat3 stiffness = Mat3::Zero();  ///< plane stress C, order (11, 22, 2*12), stress
};

/// The symmetric 6 x 6 of the energy per area on (e, c): e the strain of the given surface (11, 22, 2*12), c
/// the change of its second fundamental form, in the same frame and order.
///
/// A fibre at height z has the strain E(z) = sym[(e + z (c - e b0)) Z^-1], Z = I + z b0 (Kirchhoff and Love,
/// exact in z b0): for a cylinder's hoop, change of its length over its rest length 1 + z/R. The integral's
/// measure is det Z dz.
Mat6 wall_section_stiffness(const WallSection& section);

}  // namespace vasorod
