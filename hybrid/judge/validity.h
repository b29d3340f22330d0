// Where the model ends (design.md section 1): how near each vessel is to kinking, wrinkling or
// leaving its linear law.
#pragma once

#include <vector>

#include <vasorod/result.h>

#include "vessel/prepared_vessel.h"

namespace vasorod {

/// Adds one vessel to the scene's validity. `rigid_nodes`: rod nodes held by a rigid section;
/// elements within one radius of them are left out, for the section cannot change there.
///   brazier_ratio   k / k_cr, k the change of (u1, u2), k_cr = 0.471 t / (R^2 sqrt(1 - nu^2)):
///   long vessels
///                   only, Omega = (L/R) sqrt(t/R) >= 7 (Brazier 1927; the range of the long-tube
///                   formula)
///   wrinkling_ratio k R^2 / (0.605 t), the axial buckling strain of a cylinder: all vessels, and
///   the one
///                   that counts for short ones
///   twist_ratio     G R |u3 - u3^0| / tau_cr, tau_cr = 0.747 E (t/R)^1.25 (R/L)^0.5
///   largest_strain  of the wall's outer fibres: |v3| + |k| (R + t/2) in stretch, |u3| (R + t/2) +
///   |(v1, v2)|
///                   in shear
/// A wall with a fibre: k_cr times (E_T/E_L)^(1/2); the buckling strain times that and, where G is
/// below the ordinary modulus G0 (wall_material.h), (G/G0)^(1/2), the least of Donnell's equations
/// over all waves; tau_cr with E_L^(3/8) E_T^(5/8) for E, as bending across and stretching along
/// alone resist there. From 0.7 a ratio warns; from 0.9 the sentence says that the section would
/// kink or wrinkle, and in_range is false; so it is above a strain of 0.2, where the choice of
/// material law alone changes the answer by 13 to 32 %.
void add_validity(const PreparedVessel& vessel, const RodPoses& poses,
                  const std::vector<int>& rigid_nodes, Validity& validity);

/// Warns of a Young's modulus outside 0.01 to 100 MPa, where no vessel's wall lies: a slip of the
/// units. Not of generated tubes, whose modulus is often 1.
void warn_of_units(const VesselSpec& vessel, const Units& units, Validity& validity);

}  // namespace vasorod
