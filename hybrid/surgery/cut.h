// The cut of the Glenn operation: a vessel divided by the plane of one of its sections (design.md
// section 2, step 1).
#pragma once

#include <vector>

#include <vasorod/types.h>

#include "geometry/vertex_source.h"

namespace vasorod {

struct CutOutcome {
  TriangleSurface kept;  ///< the part that holds the end asked for; the input's vertices in their
                         ///< order, new ones after
  VertexSources kept_sources;  ///< in the input surface
  std::vector<int>
      mouth;  ///< the new end: vertices of `kept` in boundary order (the surface on the left)
  TriangleSurface stump;  ///< the other part, its mouth closed by a flat cap
  VertexSources
      stump_sources;     ///< in the input surface; the cap's inner vertices come from the mouth's
  double perimeter = 0;  ///< of the mouth, length unit
  Vec3 center = Vec3::Zero();  ///< centroid of the mouth's polygon, length unit
  Vec3 normal = Vec3::Zero();  ///< unit, of the plane, out of the kept part
};

/// Divides the surface along the plane through section.position with normal section d3. Only the
/// curve round the section is cut, wherever else the plane meets the vessel; `pick` says which
/// curve where none encloses the position. The part with the open end nearest to `keep_near` is
/// kept. The mouth lies on the plane to rounding, and no edge made here is shorter than 5 % of the
/// mean edge. Throws InputError when the cut misses the vessel, meets an open end, does not divide
/// the vessel in two, or would leave nothing.
CutOutcome cut_vessel(const TriangleSurface& surface, const Pose& section, const Vec3& pick,
                      const Vec3& keep_near);

}  // namespace vasorod
