// Whether a fitted rod can stand for its vessel. Each check throws InputError: one sentence that
// says where along the axis.
#pragma once

#include "vessel/vessel.h"

namespace vasorod {

/// The axis runs inside the surface.
void check_inside(const RodTree& rod, const TriangleSurface& surface);

/// Sections do not reach the axis' centre of curvature.
void check_bend(const RodTree& rod);

/// No wall is thicker than the vessel's mid-wall radius there. `thickness`: per node, length.
void check_thickness(const RodTree& rod, const std::vector<double>& thickness);

}  // namespace vasorod
