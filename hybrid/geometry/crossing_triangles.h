// Pairs of triangles that cross, of a whole surface or among those where something moved.
#pragma once

#include <array>
#include <vector>

#include <vasorod/types.h>

namespace vasorod {

/// Pairs of triangles that cross or overlap without being neighbours there, {smaller index,
/// larger}, sorted; a triangle without area is a pair with itself and with no other. Only pairs of
/// which one triangle at least is marked (`moved`, one entry for each triangle). At most `most`
/// pairs. Boxes first, then exact predicates (CGAL). The pairs do not depend on `threads`.
std::vector<std::array<int, 2>> crossing_triangles(const TriangleSurface& surface,
                                                   const std::vector<char>& moved, std::size_t most,
                                                   int threads = 1);

/// As many pairs as a search ends with: a crumpled surface would have one for every two triangles.
constexpr unsigned most_self_intersections = 10000;

/// All such pairs of a surface, at most `most_self_intersections`.
std::vector<std::array<int, 2>> self_intersections(const TriangleSurface& surface);

}  // namespace vasorod
