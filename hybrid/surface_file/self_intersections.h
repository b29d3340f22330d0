// Pairs of triangles of one surface that cross or overlap without being neighbours there.
#pragma once

#include <array>
#include <vector>

#include <vasorod/types.h>

namespace vasorod {

/// As many pairs as a search ends with: a crumpled surface would have one for every two triangles.
constexpr unsigned most_self_intersections = 10000;

/// Indices of triangles, sorted (CGAL, exact predicates); at most `most_self_intersections` pairs.
/// The surface must be manifold and oriented.
std::vector<std::array<int, 2>> self_intersections(const TriangleSurface& surface);

}  // namespace vasorod
