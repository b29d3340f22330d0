// The seam of an operation: matches a vessel's mouth with the other's rim, of an incision or of a
// second mouth, and makes one-to-one vertex pairs.
#pragma once

#include <array>
#include <vector>

#include <vasorod/types.h>

#include "geometry/vertex_source.h"

namespace vasorod {

/// A seam of two surfaces: the first has the mouth, the second the rim.
struct JoinOutcome {
  /// The inputs with the seam's vertices moved along their loops and others added; the inputs'
  /// vertices first.
  TriangleSurface first, second;
  VertexSources first_sources, second_sources;  ///< in the inputs
  /// {first vertex, second vertex}: every vertex of mouth and rim once, in the rim's order from
  /// rim[0], its first tip.
  std::vector<std::array<int, 2>> pairs;
  int other_tip = 0;  ///< index into `pairs` of the rim's other tip
  /// In fractions of arc length: mouth(u) meets rim(offset - u), from mouth[0] and rim[0].
  double offset = 0;
  /// RMS distance of matched points, mouth at its start and rim at rest, length unit.
  double rms_distance = 0;
};

/// Matches the loops by normalised arc length. They have opposite orientations, each with its own
/// surface on its left, so the only free number is the cyclic offset. It minimises the sum of
/// squared distances between the mouth at its start (`mouth_start`, one row per entry of `mouth`)
/// and the rim at rest, so that the seam does not twist. Then both loops get the same number of
/// vertices at equal arc length: the vertices of the loops slide along them, and where there are
/// too few, a boundary edge is split (seam_knots.h). Lengths are those of the new loops: the k-th
/// segment's share in its loop is the same on both, to rounding. So a seam of loops of equal length
/// is not strained at rest. Most slides are on the rim; the slit's tips stay and are pairs. No
/// triangle turns over, no new edge is shorter than 5 % of the mean edge. Throws InputError where
/// the triangles do not allow that.
JoinOutcome match_seam(const TriangleSurface& first, const std::vector<int>& mouth,
                       const Points& mouth_start, const TriangleSurface& second,
                       const std::vector<int>& rim, int other_tip);

/// The same for a rim without tips, that of a second mouth, which has a start too (`rim_start`).
/// Only rim[0] stays.
JoinOutcome match_seam(const TriangleSurface& first, const std::vector<int>& mouth,
                       const Points& mouth_start, const TriangleSurface& second,
                       const std::vector<int>& rim, const Points& rim_start);

/// One surface from two joined ones.
struct WeldedSurface {
  TriangleSurface
      surface;  ///< the first's vertices, then those of the second that are not on the seam
  /// Per vertex {first vertex or -1, second vertex or -1}; both on the seam.
  std::vector<std::array<int, 2>> origin;
};

/// Joins both surfaces to one for output: each pair becomes one vertex midway between the two.
WeldedSurface weld(const TriangleSurface& first, const TriangleSurface& second,
                   const std::vector<std::array<int, 2>>& pairs);

}  // namespace vasorod
