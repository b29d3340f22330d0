// The outer of two walls that meet at the ends of a vessel.
#pragma once

#include <optional>

#include <vasorod/types.h>

namespace vasorod {

/// The outer wall, point for point.
struct PartedWall {
  TriangleSurface outer;  ///< outward, open where it met the inner wall
  double thickness = 0;   ///< median distance between the walls, length
};

/// Parts a wall that has an outer and an inner face. A triangle of a face has the other face behind
/// it, across the wall's thickness; one of the rim at an end, or around a hole, has the wall's
/// length behind it. Without the rims the faces are parts of their own, the inner within the
/// outer. Nothing where they are not: the surface has one wall, or bridges cross the lumen.
/// `surface` is oriented.
std::optional<PartedWall> part_walls(const TriangleSurface& surface);

}  // namespace vasorod
