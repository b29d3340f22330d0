// The cut of the Glenn operation: the plane of a section divides a vessel.
#pragma once

#include <vector>

#include <vasorod/types.h>

#include "geometry/vertex_source.h"

namespace vasorod {

/// A cut vessel.
struct CutOutcome {
  /// The part with the end to keep: the input's vertices in their order, then new ones.
  TriangleSurface kept;
  VertexSources kept_sources;  ///< in the input surface
  /// The new end: vertices of `kept` in boundary order (the surface on the left).
  std::vector<int> mouth;
  TriangleSurface stump;  ///< the other part, its mouth closed by a flat cap
  /// In the input surface. The cap's inner vertices are means of the mouth's.
  VertexSources stump_sources;
  double perimeter = 0;        ///< of the mouth, length unit
  Vec3 center = Vec3::Zero();  ///< centroid of the mouth's polygon, length unit
  Vec3 normal = Vec3::Zero();  ///< unit normal of the plane, out of the kept part
};

/// Divides the surface along the plane through section.position with the normal d3 of the section.
/// Only the curve around the section is cut, not other curves of the plane and the vessel; if no
/// curve encloses the position, `pick` selects the curve. The part with the open end nearest to
/// `keep_near` is kept. The mouth lies on the plane to rounding, and no new edge is shorter than
/// 5 % of the mean edge. Throws InputError if the cut misses the vessel, meets an open end, does
/// not divide the vessel in two, or would leave nothing.
CutOutcome cut_vessel(const TriangleSurface& surface, const Pose& section, const Vec3& pick,
                      const Vec3& keep_near);

}  // namespace vasorod
