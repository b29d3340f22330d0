// Stiffness of a wall per area of its given surface, integrated through the thickness with the rest
// curvature.
#pragma once

#include <vasorod/types.h>

namespace vasorod {

/// The wall at a point, in the frame (fibre, across). All lengths in one unit, all stresses in one
/// unit.
struct WallSection {
  double inner = 0, outer = 0;  ///< heights of its faces over the given surface, outward positive
  /// b0 of the given surface (11, 22, 12), positive where convex, 1/length.
  Vec3 curvature = Vec3::Zero();
  Mat3 stiffness = Mat3::Zero();      ///< plane stress, order (11, 22, 2*12)
  Vec2 shear_modulus = Vec2::Zero();  ///< transverse, for fibres in direction 1 and 2
};

/// The symmetric 6 x 6 matrix of the energy per area on (e, c): e the strain of the given surface
/// (11, 22, 2*12), c the change of its second fundamental form, in the same frame and order.
///
/// A fibre at height z has the strain (Kirchhoff and Love, exact in z b0)
///
/// ```
/// E(z) = sym[(e + z (c - e b0)) Z^-1],   Z = I + z b0
/// ```
///
/// For the hoop direction of a cylinder this is the change of the fibre's length over its rest
/// length 1 + z/R. The measure of the integral is det Z dz.
Mat6 wall_section_stiffness(const WallSection& section);

/// Bending compliance from transverse shear of a thick wall, along the unit direction d, in
/// 1 / (force length):
///
/// ```
/// 4 k^2 / (5/6 G t)
/// ```
///
/// Where a section of curvature k ovalises, its moment varies as cos 2 theta and its shear force is
/// 2 k M. Exact for the mode n = 2 of a ring, zero for a flat wall. At t/R = 0.2 the effect is 5 %
/// of the ring's stiffness.
double shear_compliance(const WallSection& section, const Vec2& d, double curvature);

/// Adds a compliance (subtracts it if negative) to bending along the unit direction d.
void add_bending_compliance(Mat6& stiffness, const Vec2& d, double compliance);

/// The same correction as a map M of (e, c): M^T stiffness M is the stiffness with the compliance.
Mat6 less_bending(const Mat6& stiffness, const Vec2& d, double compliance);

}  // namespace vasorod
