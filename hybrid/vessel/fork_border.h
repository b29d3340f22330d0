// Draws the borders between paths anew from fitted axes: a wall point belongs to a branch where it
// stands out of the tube the branch leaves from. The flow alone draws borders that lean with it,
// and none at all on a stub shorter than its width.
#pragma once

#include "vessel/centerline.h"

namespace vasorod {

/// `first`: a centerline fitted with the borders of the flow. `centers`: of the ends.
AxisPaths redraw_borders(const TriangleSurface& surface, const std::vector<Edge>& edges,
                         const Centerline& first, const std::vector<Vec3>& centers);

}  // namespace vasorod
