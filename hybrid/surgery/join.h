// The seam of the Glenn operation: which point of the SVC's mouth goes to which point of the
// incision's rim (design.md section 2, step 3), and one-to-one vertex pairs there.
#pragma once

#include <array>
#include <vector>

#include <vasorod/types.h>

#include "geometry/vertex_source.h"

namespace vasorod {

struct JoinOutcome {
  TriangleSurface svc,
      rpa;  ///< the inputs with some boundary edges of the seam split; the inputs' vertices first
  VertexSources svc_sources, rpa_sources;  ///< in the inputs
  std::vector<std::array<int, 2>>
      pairs;          ///< {svc vertex, rpa vertex}, every vertex of mouth and rim once,
                      ///< in the rim's order from rim[0], its first tip
  int other_tip = 0;  ///< index into `pairs` of the rim's other tip
  double offset = 0;  ///< fractions of arc length: mouth(u), u from mouth[0], meets rim(offset -
                      ///< u), from rim[0]
  double rms_distance =
      0;  ///< between matched points, mouth at its start and rim at rest, length unit
};

/// Matches the loops by normalised arc length. They run in opposite senses, each with its own
/// surface on its left, so one number is free, the cyclic offset: the one that minimises the sum of
/// squared distances between the mouth at its start
/// (`mouth_start`, one row per entry of `mouth`) and the rim at rest, so that the seam does not
/// twist. Then both get the same number of vertices: two that lie within 0.3 of the mean edge of
/// each other are paired, opposite any other the boundary edge is split. The slit's tips are
/// vertices of the rim, so they are vertices of the mouth too.
JoinOutcome match_seam(const TriangleSurface& svc, const std::vector<int>& mouth,
                       const Points& mouth_start, const TriangleSurface& rpa,
                       const std::vector<int>& rim, int other_tip);

struct WeldedSurface {
  TriangleSurface surface;  ///< the SVC's vertices, then those of the RPA that are not on the seam
  std::vector<std::array<int, 2>>
      origin;  ///< per vertex {svc vertex or -1, rpa vertex or -1}; both on the seam
};

/// One surface of both for what is written out: each pair becomes one vertex midway between the
/// two.
WeldedSurface weld(const TriangleSurface& svc, const TriangleSurface& rpa,
                   const std::vector<std::array<int, 2>>& pairs);

}  // namespace vasorod
