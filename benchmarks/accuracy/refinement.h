// Effect of mesh refinement on the points and the moment of a bent tube, on regular and irregular
// meshes: tube R 10, L 100, t 1, nu 0.3, bent to half its Brazier curvature between rigid ends.
#pragma once

#include <functional>
#include <vector>

#include "accuracy/held_tube.h"

namespace vasorod::bench {

/// A family of meshes.
struct RefinedMesh {
  const char* name;
  std::function<TubeMesh(int)> make;  ///< with this many vertices around
  std::vector<int> around;  ///< 3,000 to 100,000 vertices, the first three each twice as fine
};
std::vector<RefinedMesh> refined_meshes();

struct BentTube {
  HeldTube tube;
  HeldAnswer answer;
  explicit BentTube(TubeMesh mesh);
};

/// Largest distance of the tube's vertices from the positions of the same material points in the
/// reference, a structured mesh with `around` vertices around. Length.
double largest_distance(const BentTube& bent, const BentTube& reference, int around);

/// Prints the table of all meshes compared with the finest structured one.
void refinement();

}  // namespace vasorod::bench
