// Pairs of triangles that cross, among those where something moved.
#pragma once

#include <array>
#include <vector>

#include <vasorod/types.h>

namespace vasorod {

/// Pairs of triangles that cross or overlap without being neighbours there, {smaller index,
/// larger}, sorted; a triangle without area is a pair with itself and with no other. Only pairs of
/// which one triangle at least is marked (`moved`, one entry for each triangle). At most `most`
/// pairs. Boxes first, then exact predicates (CGAL): the same pairs as self_intersections()
/// (surface_file/self_intersections.h) finds, which checks all of them.
std::vector<std::array<int, 2>> crossing_triangles(const TriangleSurface& surface,
                                                   const std::vector<char>& moved,
                                                   std::size_t most);

}  // namespace vasorod
