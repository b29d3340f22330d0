// Makes the curve f = 0 on a triangle surface a cycle of its edges, without slivers.
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "geometry/surface_editor.h"

namespace vasorod {

/// Splits the listed edges where f = 0, f given at vertices and linear along edges, so that the
/// closed curve through them becomes a cycle of edges. A vertex with a crossing nearer than the
/// editor's snap distance is moved onto it along its edge instead (snap before split), each edge is
/// split once, and short edges that remain are merged away. Only the listed edges are touched, so a
/// plane that meets another part of the vessel leaves that alone. Returns the cycle with f > 0 on
/// its left seen from outside, or an empty one when the surface is too coarse there for a simple
/// cycle.
std::vector<int> split_level_set(SurfaceEditor& editor, const std::vector<double>& f,
                                 const std::vector<std::array<int, 2>>& edges);

}  // namespace vasorod
