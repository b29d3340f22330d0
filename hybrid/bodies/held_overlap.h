// Rigid ends that are held inside each other. The walls between them cannot yield at any pressure,
// so the contact problem has no solution there and contact near them is left out.
#pragma once

#include <vector>

#include "geometry/closest_point.h"

namespace vasorod {

/// A body and its held ends. All lengths in one unit.
struct HeldBody {
  const ClosestPoint& rest;
  /// p' [6]: where the rod's sections move the vertices rigidly.
  const ClosestPoint& carried;
  const std::vector<char>& fixed;  ///< per vertex: held at `carried`
  double offset = 0;               ///< from the surface to the outer face of the wall
};

/// Overlap of the held ends of two bodies.
struct HeldOverlap {
  double depth = 0;             ///< deepest overlap beyond the overlap at rest, length
  std::vector<int> in_a, in_b;  ///< held vertices near which the walls overlap
};

/// Finds held vertices of one body that lie inside the wall of the other, deeper than their
/// distance from the other's held edges: the walls in between would have to dent more steeply than
/// 45 degrees.
HeldOverlap held_overlap(const HeldBody& a, const HeldBody& b);

}  // namespace vasorod
