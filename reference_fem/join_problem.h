// A scene's join of two generated tubes as a dimensionless finite-element problem: the vein's cut
// end is joined to a slit in the artery's wall, or to the rim of a second tube end to end. Lengths
// over the mid-wall radius of the cut, stresses over the vein's axial modulus. Scenes that the
// reference cannot solve are refused here with one sentence.
//
// Axes: origin at the middle of the slit on the mid-wall, x along the artery, z out of its wall, so
// the vein comes from +z. End to end: origin at the middle of the first vessel's rim, z out of that
// vessel.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include <vasorod/scene.h>

#include "reference_fem/hole_chart.h"
#include "reference_fem/scene_parts.h"

namespace vasorod::fem {

/// One tube of the join, unrolled from the line through the slit's tip at +x (vein) or through the
/// slit (artery), first towards +y.
struct JoinWall {
  std::string name;
  TubeShape shape;  ///< of the vein: the kept part
  Moduli moduli;
  LawKind law = LawKind::neo_hookean;
  std::vector<EndProblem> ends;
  SeenState seen;          ///< its pressures act on the inner face
  double first_angle = 0;  ///< of the first line, radians
  int turn = 1;            ///< sense of the tube's angle along the strip
  /// The hole around which the strip is laid; empty: none, or a slit.
  std::optional<HoleChart> hole;
  /// The vessel as it was seen, not cut; `shape` is its part between two fractions of its axis.
  TubeShape whole;
  double kept_from = 0, kept_to = 1;
  std::vector<EndProblem> ends_when_seen;  ///< all held

  /// The tube's parameters at a share of the circumference, a fraction of the axis and a depth,
  /// which counts inwards where `turn` is negative, so that the strip is right-handed.
  Vec3 parameters(double share, double fraction, double depth = 0.5) const;
  Vec3 parameters(const Vec3& strip) const { return parameters(strip[0], strip[1], strip[2]); }
};

/// The vessel as it was seen: not cut, not incised, all of `ends_when_seen` held.
JoinWall as_seen(const JoinWall& wall);

/// The slit, a part of the artery's first line, or the elliptic hole around which that part is
/// laid. A point of its rim is named by its share of the rim's length from the tip at +x, first
/// along the lip at y > 0.
struct Incision {
  double from = 0, to = 0;  ///< tips, fractions of the artery's axis
  double length = 0;        ///< from tip to tip
  double perimeter = 0;     ///< length of the rim
  /// The share of the rim of a point at the artery's strip parameters (share 0 or 1 of the
  /// circumference).
  double rim_share(const Vec3& parameter) const;
  /// Its inverse: the strip parameters of the rim's point at a share in [0, 1).
  Vec3 rim_parameter(double share) const;
};

/// The rim of the second vessel of an end-to-end join.
struct OtherRim {
  int side = 0;              ///< of its tube
  double fraction = 1;       ///< kept length over the tube's
  std::optional<Vec3> pick;  ///< of a cut, the scene's; empty: it is whole
};

/// The join.
struct JoinProblem {
  JoinWall vein, artery;
  bool vein_first = true;  ///< in the scene's list of vessels
  int seam_side = 1;       ///< the vein's side at the seam
  Incision incision;       ///< of an end-to-end join: none
  /// End to end: the "artery" is the second vessel, whose rim lies on the "vein's". Empty: the
  /// incision is the rim.
  std::optional<OtherRim> other_rim;
  double rotation = 0;  ///< of the vein's mouth about +z, radians
  /// Planes of symmetry: normal x (between the slit's tips) and normal y (through them).
  std::array<bool, 2> mirror{};
  std::optional<Vec3> cut_pick;  ///< of the first vessel, the scene's; empty: it is whole
  double cut_fraction = 0;       ///< kept length over the vein's length
  double axis_turn = 0;          ///< angle from the vein's axis to the slit's normal, or between
                                 ///< the rims, 0: face to face, radians
  Pose frame;                    ///< the problem's axes in the scene's, dimensionless position
  ProblemUnits units;

  /// Whether a wall carried a stress when it was seen.
  bool stressed() const { return vein.seen.stressed() || artery.seen.stressed(); }
  /// The number of copies of the model that make the whole.
  int copies() const { return (mirror[0] ? 2 : 1) * (mirror[1] ? 2 : 1); }
  /// A vector of the problem in the scene's axes.
  Vec3 in_scene(const Vec3& vector) const { return frame.rotation * vector; }
};

/// Replaces the slit by an ellipse of that length and width about its middle, drawn on the wall as
/// unrolled there. False: it meets an end of the artery or itself.
bool open_ellipse(JoinProblem& problem, double length, double width);

/// Of the scene's operation, either of the two. Throws InputError. `law` overrides the scene's
/// laws.
JoinProblem read_join(const Scene& scene, std::optional<LawKind> law);

}  // namespace vasorod::fem
