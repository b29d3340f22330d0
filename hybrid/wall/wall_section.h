// Stiffness of a wall per area of its given surface, integrated through the thickness with the
// curvature it has at rest.
#pragma once

#include <vasorod/types.h>

namespace vasorod {

/// A wall at a point, in the frame (fibre, across). Lengths and stresses in any one unit each.
struct WallSection {
  double inner = 0, outer = 0;  ///< its faces along the outward normal, from the given surface
  Vec3 curvature =
      Vec3::Zero();  ///< b0 of the given surface (11, 22, 12), positive where convex, 1/length
  Mat3 stiffness = Mat3::Zero();      ///< plane stress, order (11, 22, 2*12)
  Vec2 shear_modulus = Vec2::Zero();  ///< across the thickness, of fibres in direction 1 and 2
};

/// The symmetric 6 x 6 of the energy per area on (e, c): e the strain of the given surface (11, 22,
/// 2*12), c the change of its second fundamental form, in the same frame and order.
///
/// A fibre at height z has the strain E(z) = sym[(e + z (c - e b0)) Z^-1], Z = I + z b0 (Kirchhoff
/// and Love, exact in z b0): for a cylinder's hoop, change of its length over its rest length 1 +
/// z/R. The integral's measure is det Z dz.
Mat6 wall_section_stiffness(const WallSection& section);

/// A thick wall also shears across its thickness. Where a section of curvature k ovalises, its
/// moment goes as cos 2 theta and its shear force is 2 k M: the shear adds 4 k^2 / (5/6 G t) to the
/// compliance of bending along the unit direction d (1 / (force length)). Exact for the ring's mode
/// n = 2, nothing for a flat wall. At t/R = 0.2 that is 5 % of the ring's stiffness.
double shear_compliance(const WallSection& section, const Vec2& d, double curvature);

/// Adds a compliance (negative: takes it away) to bending along the unit direction d.
void add_bending_compliance(Mat6& stiffness, const Vec2& d, double compliance);

}  // namespace vasorod
