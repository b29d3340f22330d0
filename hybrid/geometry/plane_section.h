// The curves in which a plane meets a triangle surface, and the area, centroid and perimeter they
// enclose.
#pragma once

#include <array>
#include <vector>

#include <vasorod/types.h>

namespace vasorod {

/// One curve of a plane with a surface.
struct SectionLoop {
  Points points;               ///< in order; the last is joined to the first when closed
  bool closed = true;          ///< false: the curve runs from one boundary edge to another
  std::vector<int> triangles;  ///< the triangles it passes through, in order
  std::vector<std::array<int, 2>> edges;  ///< points.row(i) lies on the edge between these vertices
};

/// All curves of the plane through `point` with unit `normal`; a vertex exactly on the plane counts
/// as above it, so every curve is simple and the closed ones turn counter-clockwise about `normal`
/// round an outwards oriented tube.
std::vector<SectionLoop> plane_sections(const TriangleSurface& surface, const Vec3& point,
                                        const Vec3& normal);

/// Index of the curve that encloses `point` (the one with the smallest area where several do), or,
/// where none does, the one that passes closest to it; -1 when there are no curves. Open curves
/// enclose nothing.
int section_around(const std::vector<SectionLoop>& loops, const Vec3& point, const Vec3& normal);

double section_area(const SectionLoop& loop);  ///< enclosed by the closed polygon, length^2
Vec3 section_centroid(
    const SectionLoop& loop);  ///< of the enclosed area; of the points where that is zero
double section_perimeter(const SectionLoop& loop);  ///< closing edge included when closed, length

/// Area enclosed by the polygon moved inwards by `distance` everywhere: area - distance * perimeter
/// + pi * distance^2 (Steiner; exact for smooth convex curves), not below 0. With t/2: the lumen
/// inside a mid-wall section.
double inset_area(const SectionLoop& loop, double distance);

}  // namespace vasorod
