// Closes a planar hole of a surface with well-shaped triangles.
#pragma once

#include <vector>

#include <vasorod/types.h>

#include "geometry/vertex_source.h"

namespace vasorod {

struct CappedSurface {
  TriangleSurface surface;  ///< the input's points and triangles first, the cap's after
  VertexSources sources;    ///< in the input surface; a cap's inner vertex is a
                            ///< mean of three rim vertices
};

/// Fills the boundary loop (in boundary order) of `surface`, which must be
/// planar, with triangles of the size of its edges.
CappedSurface close_planar_hole(const TriangleSurface& surface, const std::vector<int>& loop);

}  // namespace vasorod
