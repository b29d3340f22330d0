// Recomputes the borders between paths from fitted axes: a wall point belongs to a branch if it
// lies outside the tube that the branch leaves. The flow alone gives borders that lean with the
// flow, and no border on a stub shorter than its width.
#pragma once

#include "vessel/centerline.h"

namespace vasorod {

/// `first`: a centerline fitted with the flow's borders. `centers`: of the ends, length.
AxisPaths redraw_borders(const TriangleSurface& surface, const std::vector<Edge>& edges,
                         const Centerline& first, const std::vector<Vec3>& centers);

}  // namespace vasorod
