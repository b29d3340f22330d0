// Smooths a surface that has moved without giving up its shape at rest.
#pragma once

#include <vector>

#include "geometry/moved_with.h"

namespace vasorod {

/// Moves the chosen vertices, `rounds` times, most of the way to where their umbrella Laplacian l
/// (geometry/umbrella.h) is that of the shape at rest, turned with them:
///
/// ```
/// x_i -> x_i + l(x)_i - R_i l(p)_i
/// ```
///
/// so that a crease along one edge spreads over the edges beside it, and a rigid motion stays as it
/// is. Vertices of rims should not be among them.
void smooth_moved(const TriangleSurface& rest, const std::vector<int>& chosen, int rounds,
                  MovedSurface& moved);

}  // namespace vasorod
