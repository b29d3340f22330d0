// Pairs of triangles of one surface that cross or overlap without being neighbours there.
#pragma once

#include <array>
#include <vector>

#include <vasorod/types.h>

namespace vasorod {

/// Indices of triangles, sorted (CGAL, exact predicates). The surface must be manifold and
/// oriented.
std::vector<std::array<int, 2>> self_intersections(const TriangleSurface& surface);

}  // namespace vasorod
