// The curves in which a plane meets a triangle surface; area, centroid and perimeter of these
// curves.
#pragma once

#include <array>
#include <vector>

#include <vasorod/types.h>

#include "geometry/box_tree.h"

namespace vasorod {

/// One curve of a plane section.
struct SectionLoop {
  Points points;               ///< in order; the last is joined to the first when closed
  bool closed = true;          ///< false: the curve runs from one boundary edge to another
  std::vector<int> triangles;  ///< the triangles it passes through, in order
  std::vector<std::array<int, 2>> edges;  ///< points.row(i) lies on the edge between these vertices
};

/// All curves of the plane through `point` with unit `normal`. A vertex exactly on the plane counts
/// as above it, so every curve is simple. The closed curves of an outward oriented tube turn
/// counter-clockwise about `normal`.
std::vector<SectionLoop> plane_sections(const TriangleSurface& surface, const Vec3& point,
                                        const Vec3& normal);

/// The curves of many planes in one surface, which must outlive it: a tree of boxes finds the
/// triangles of each. The same curves as plane_sections() gives.
class PlaneSections {
 public:
  explicit PlaneSections(const TriangleSurface& surface);
  /// plane_sections() of the surface.
  std::vector<SectionLoop> across(const Vec3& point, const Vec3& normal) const;

 private:
  const TriangleSurface& surface_;
  BoxTree boxes_;
  double extent_;  // the largest coordinate, length
};

/// How often the closed polygon turns about `center`, seen along `normal`: 1 once,
/// counter-clockwise.
int section_winding(const Points& polygon, const Vec3& center, const Vec3& normal);

/// Index of the curve that encloses `point` (the one with the smallest area if there are several).
/// If none does: the curve closest to `point`. -1: there are no curves. Open curves enclose
/// nothing.
int section_around(const std::vector<SectionLoop>& loops, const Vec3& point, const Vec3& normal);

/// Area enclosed by the closed polygon, length^2.
double section_area(const SectionLoop& loop);
/// Centroid of the enclosed area; centroid of the points if that area is zero.
Vec3 section_centroid(const SectionLoop& loop);
/// Perimeter, with the closing edge of closed curves, length.
double section_perimeter(const SectionLoop& loop);

/// Area enclosed by the polygon moved inwards by `distance`, length^2: area - distance * perimeter
/// + pi * distance^2 (Steiner; exact for smooth convex curves), at least 0. With the distance t/2:
/// the lumen inside a mid-wall section.
double inset_area(const SectionLoop& loop, double distance);

}  // namespace vasorod
