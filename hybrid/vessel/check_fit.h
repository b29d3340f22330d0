// Checks whether a fitted rod can represent its vessel. Each check throws InputError: one sentence
// with the place along the axis.
#pragma once

#include "vessel/vessel.h"

namespace vasorod {

/// The axis runs inside the surface.
void check_inside(const RodTree& rod, const TriangleSurface& surface);

/// No section reaches the axis's centre of curvature.
void check_bend(const RodTree& rod);

/// The wall is nowhere thicker than the mid-wall radius. `thickness`: per node, length.
void check_thickness(const RodTree& rod, const std::vector<double>& thickness);

}  // namespace vasorod
