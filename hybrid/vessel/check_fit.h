// Checks whether a fitted rod can represent its vessel. Each check throws InputError: one sentence
// with the place along the axis.
#pragma once

#include <functional>

#include "vessel/vessel.h"

namespace vasorod {

/// The axis runs inside the surface. `beside_fork`: whether the sections at a place are open
/// because another branch leaves there; the axis only bridges them.
void check_inside(const RodTree& rod, const TriangleSurface& surface,
                  const std::function<bool(const Vec3&)>& beside_fork);

/// The axis is at least a hundredth of the largest radius long: what is shorter is a rim.
void check_length(const RodTree& rod);

/// No section reaches the axis's centre of curvature.
void check_bend(const RodTree& rod);

/// The wall is nowhere thicker than the mid-wall radius. `thickness`: per node, length.
void check_thickness(const RodTree& rod, const std::vector<double>& thickness);

}  // namespace vasorod
