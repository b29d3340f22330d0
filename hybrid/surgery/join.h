// The seam of the Glenn operation: matches the SVC's mouth with the incision's rim and makes
// one-to-one vertex pairs.
#pragma once

#include <array>
#include <vector>

#include <vasorod/types.h>

#include "geometry/vertex_source.h"

namespace vasorod {

/// A seam.
struct JoinOutcome {
  /// The inputs with some boundary edges of the seam split; the inputs' vertices first.
  TriangleSurface svc, rpa;
  VertexSources svc_sources, rpa_sources;  ///< in the inputs
  /// {svc vertex, rpa vertex}: every vertex of mouth and rim once, in the rim's order from rim[0],
  /// its first tip.
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
/// vertices: two vertices within 0.3 of the mean edge are paired; opposite every other vertex the
/// boundary edge is split. The slit's tips are vertices of the rim and thus also of the mouth.
JoinOutcome match_seam(const TriangleSurface& svc, const std::vector<int>& mouth,
                       const Points& mouth_start, const TriangleSurface& rpa,
                       const std::vector<int>& rim, int other_tip);

/// One surface from two joined ones.
struct WeldedSurface {
  TriangleSurface surface;  ///< the SVC's vertices, then those of the RPA that are not on the seam
  /// Per vertex {svc vertex or -1, rpa vertex or -1}; both on the seam.
  std::vector<std::array<int, 2>> origin;
};

/// Joins both surfaces to one for output: each pair becomes one vertex midway between the two.
WeldedSurface weld(const TriangleSurface& svc, const TriangleSurface& rpa,
                   const std::vector<std::array<int, 2>>& pairs);

}  // namespace vasorod
