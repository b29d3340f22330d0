// Closes a planar hole of a surface with well-shaped triangles.
#pragma once

#include <vector>

#include <vasorod/types.h>

#include "geometry/vertex_source.h"

namespace vasorod {

/// A surface with a closed hole.
struct CappedSurface {
  TriangleSurface surface;  ///< the input's points and triangles first, the cap's after
  /// In the input surface. An inner vertex of the cap is a mean of three rim vertices.
  VertexSources sources;
};

/// Fills a planar boundary loop (in boundary order) of `surface` with triangles of the size of the
/// loop's edges.
CappedSurface close_planar_hole(const TriangleSurface& surface, const std::vector<int>& loop);

}  // namespace vasorod
