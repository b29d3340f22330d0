// Smooths a surface that has moved without giving up its shape at rest.
#pragma once

#include <vector>

#include "geometry/moved_with.h"

namespace vasorod {

/// Moves the chosen vertices, `rounds` times, most of the way to where their neighbours j and the
/// shape at rest, turned with them, have them:
///
/// ```
/// x_i -> mean x_j + R_i (p_i - mean p_j)
/// ```
///
/// so that a crease along one edge spreads over the edges beside it, and a rigid motion stays as it
/// is. Vertices of rims should not be among them.
void smooth_moved(const TriangleSurface& rest, const std::vector<int>& chosen, int rounds,
                  MovedSurface& moved);

}  // namespace vasorod
