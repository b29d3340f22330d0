// Limits of the model: how close each vessel is to kinking, wrinkling or the end of its linear law.
#pragma once

#include <vector>

#include <vasorod/result.h>

#include "vessel/prepared_vessel.h"
#include "wall/wall_energy.h"

namespace vasorod {

/// What add_validity has to know of a vessel beside its rod.
struct JudgedState {
  /// Rod nodes held by a rigid section. Elements within one radius of them are left out, because
  /// the section cannot change there.
  std::vector<int> rigid_nodes;
  /// Per rod element: whether an incision opens the section there; left out too. Empty: none.
  std::vector<char> opened;
  /// The deformed surface where walls were solved: there the wall itself gives largest_strain
  /// beside a fork, the largest |lambda - 1| of a triangle's principal stretches. Empty: the rod
  /// gives it everywhere.
  Points walls;
  /// Whether the model's sections flatten when it bends: the softening of tubes curved at rest is
  /// in its answer.
  bool sections_flatten = false;
  /// Whether the pressure in the lumen counts.
  bool pressed = true;
};

/// Adds one vessel to the scene's validity. Within the reach of a fork (vessel/fork_reach.h)
/// sections are no tubes, and the ratios leave these elements out.
///
/// brazier_ratio: k / k_cr, k the change of (u1, u2), k_cr = 0.471 t / (R^2 sqrt(1 - nu^2)). Long
/// vessels only, Omega = (L/R) sqrt(t/R) >= 7 (Brazier 1927; the range of the long-tube formula).
///
/// A pressure p in the lumen (after the operation) holds the section open: k_cr is multiplied by
/// (1 + p / p_c)^(1/2), p_c of judge/lumen_pressure.h.
///
/// wrinkling_ratio: k R / (0.605 t / R + p R / (2 t E)), with the axial buckling strain of a
/// cylinder and the axial tension of a pressure p from inside (p pi R^3 / 2 in the moment of NASA
/// SP-8007; its gain in the buckling strain itself, which makes up for imperfections, is left out;
/// so are other axial strains). All vessels; for short vessels, this ratio is the relevant one.
///
/// twist_ratio: G R |u3 - u3^0| / tau_cr, tau_cr = 0.747 E (t/R)^1.25 (R/L)^0.5.
///
/// largest_strain: of the wall's outer fibres, |v3| + |k| (R + t/2) in stretch,
/// |u3| (R + t/2) + |(v1, v2)| in shear.
///
/// A wall with a fibre: k_cr is multiplied by (E_T/E_L)^(1/2). The buckling strain is multiplied by
/// the same factor and, if G is below the ordinary modulus G0 (ordinary_shear in
/// wall/plane_stress.h), by (G/G0)^(1/2): the minimum of Donnell's equations over all waves. tau_cr
/// uses E_L^(3/8) E_T^(5/8) for E, because only transverse bending and axial stretching resist.
///
/// A ratio of 0.7 or more gives a warning. From 0.9 on the warning says that the section would kink
/// or wrinkle, and in_range is false. in_range is also false above a strain of 0.2, where the
/// choice of material law alone changes the answer by 13 to 32 %.
void add_validity(const PreparedVessel& vessel, const RodPoses& poses, const JudgedState& state,
                  Validity& validity);

/// Warns of a wall whose faces are strained past 0.2 at one place, if its law is biot or svk: these
/// soften in compression where a wall stiffens. The strain of a face counts the folding that
/// largest_strain, taken from the rod, does not see: at the tip of a slit, along a seam.
void warn_of_law(const VesselSpec& vessel, const FaceExtremes& faces, Validity& validity);

/// Warns of a Young's modulus outside 0.01 to 100 MPa. No vessel has one, so the units are probably
/// wrong. Generated tubes are not checked; their modulus is often 1.
void warn_of_units(const VesselSpec& vessel, const Units& units, Validity& validity);

/// Warns of a vessel whose mean radius, in the unit it was read in, is that of the same vessel in
/// another unit: below 1.5 mm or above 20 mm.
void warn_of_radius(const std::string& vessel, double radius, const Units& units,
                    Validity& validity);

/// Of a Glenn operation: warns where the vein's mouth has to turn by more than 90 degrees to meet
/// the incision from outside. Then the part that was cut off would have to turn by less than 90
/// degrees, so that the scene probably keeps the wrong one.
void warn_of_keep(const GlennReport& glenn, Validity& validity);

/// Of an end-to-end join: warns where the rims have to turn by more than 90 degrees to face each
/// other. Then the scene probably keeps, or joins, the wrong end of a vessel.
void warn_of_keep(const EndToEndReport& report, Validity& validity);

}  // namespace vasorod
