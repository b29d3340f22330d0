// The outer wall of a surface that has two, or that crosses itself.
#pragma once

#include <optional>

#include <vasorod/types.h>

namespace vasorod {

/// Median distance from the wall outwards to a wall that faces it, length: the lumen's width, where
/// there is an inner wall; 0 where no wall faces another.
double facing_width(const TriangleSurface& surface);

/// A closed wall around everything.
struct OuterWall {
  TriangleSurface surface;  ///< closed, outward, without handles
  double ball = 0;          ///< radius of the ball that does not pass its openings, length
  double lifted = 0;        ///< share of its points that the input's wall is not near
};

/// The alpha wrap (Portaneri et al. 2022, CGAL) of a surface by the smallest of a few balls that
/// leaves no handle: one that does not enter the lumen between two walls. Its points, which lie off
/// the wall by the wrap's offset, are put back on the input. Nothing if every ball leaves a handle.
std::optional<OuterWall> outer_wall(const TriangleSurface& surface);

}  // namespace vasorod
