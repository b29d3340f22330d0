// Embeds the curve f = 0 on a triangle surface as a cycle of mesh edges, without slivers.
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "geometry/surface_editor.h"

namespace vasorod {

/// Splits the listed edges where f = 0 so that the closed curve becomes a cycle of edges. f is
/// given at vertices and linear along edges. If a crossing is closer to a vertex than the editor's
/// snap distance, the vertex is moved to the crossing along its edge (snap before split). Each edge
/// is split once; remaining short edges are collapsed. Only the listed edges change, so other parts
/// of the vessel that the plane meets stay as they are. Returns the cycle with f > 0 on its left,
/// seen from outside, or an empty one if the surface is too coarse for a simple cycle.
std::vector<int> split_level_set(SurfaceEditor& editor, const std::vector<double>& f,
                                 const std::vector<std::array<int, 2>>& edges);

/// The triangles on each side of a cycle of edges, by a flood fill that does not cross it; one
/// ascending list per connected part.
std::vector<std::vector<int>> parts_beside(const SurfaceEditor& editor,
                                           const std::vector<int>& cycle);

}  // namespace vasorod
