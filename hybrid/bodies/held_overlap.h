// Rigid ends that are held inside each other: between them no wall can yield, whatever the
// pressure, so contact beside them has no answer and is left out.
#pragma once

#include <vector>

#include <vasorod/types.h>

namespace vasorod {

/// A body and where its ends are held. Lengths in one unit.
struct HeldBody {
  const TriangleSurface& rest;
  const Points& carried;  ///< where the whole body would be if its sections went rigidly along
  const std::vector<char>& fixed;  ///< per vertex: held there
  double offset = 0;               ///< from the surface to the wall's outer face
};

struct HeldOverlap {
  double depth = 0;             ///< the deepest, beyond what overlaps at rest
  std::vector<int> in_a, in_b;  ///< held vertices beside which it happens
};

/// Held vertices of one inside the other's wall, deeper than they are far from the other's held
/// edges: the walls in between would have to dent more steeply than 45 degrees.
HeldOverlap held_overlap(const HeldBody& a, const HeldBody& b);

}  // namespace vasorod
