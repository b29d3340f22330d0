// Degenerate triangles of a manifold surface: short edges collapsed, flat triangles straightened.
#pragma once

#include "surface_file/read_surface.h"

namespace vasorod {

/// Edges and triangle heights below this fraction of the mean edge count as degenerate. At 1e-3 a
/// triangle is far below what any scan resolves, its normal is rounding, and its stiffness (which
/// grows as the inverse square of its size) would be 1e6 times its neighbours'; a fine but
/// sound mesh has no such triangles.
constexpr double degenerate_fraction = 1e-3;

/// Collapses edges shorter than degenerate_fraction times the mean edge (onto the lower point
/// number, or onto the point on an end), then turns the longest edge of triangles whose height is
/// below it. Topology is kept. Counts go into the report. The surface must be manifold and
/// oriented.
void clean_surface(LoadedSurface& loaded);

}  // namespace vasorod
