// A surface of any orientation, with islands, holes and doubled walls, made one oriented part.
#pragma once

#include <string>
#include <vector>

#include <vasorod/types.h>

namespace vasorod {

/// Doubled points and triangles removed, neighbours oriented alike, edges of more than two
/// triangles taken apart. Returns one phrase for each thing that was done.
std::vector<std::string> orient(TriangleSurface& surface);

/// A connected part that was left out.
struct LeftOut {
  Vec3 center = Vec3::Zero();  ///< mean of its points, length
  double volume = 0;           ///< with flat lids, length^3
  bool inside = false;         ///< within the kept part: an inner wall or a cavity
};

/// Keeps the part of the largest volume, outward; returns the others, largest first.
std::vector<LeftOut> keep_largest(TriangleSurface& surface);

/// What the boundary loops of a surface are: an end's wall runs along the axis, across the plane of
/// the loop; the wall around a hole lies in it.
struct Openings {
  std::vector<std::vector<int>> ends, holes;
};
Openings openings_of(const TriangleSurface& surface);

/// Largest distance of the loop's points from their mean plane over its radius.
double unevenness(const Points& points, const std::vector<int>& loop);

/// Closes the loops by a smooth continuation of the wall around them (CGAL: Liepa 2003, fairing).
/// The first points and triangles stay as they are.
void fill_loops(TriangleSurface& surface, const std::vector<std::vector<int>>& loops);

/// Number of handles of a connected surface.
int handles_of(const TriangleSurface& surface);

}  // namespace vasorod
