// The incision of the Glenn operation: a slit parallel to the rod, its midpoint at the pick
// (design.md section 2, step 2).
#pragma once

#include <array>
#include <vector>

#include <vasorod/types.h>

#include "geometry/vertex_source.h"
#include "rod/binding.h"
#include "rod/rod_tree.h"

namespace vasorod {

struct IncisionOutcome {
  TriangleSurface surface;  ///< opened; the input's vertices first, new ones after
  VertexSources sources;    ///< in the input surface
  std::vector<int> rim;     ///< the slit's boundary loop (the surface on its left), from the tip of
                            ///< smaller arc length s
  int other_tip = 0;        ///< index into `rim` of the tip of larger s
  int middle = 0;           ///< index into `rim` of the pick's vertex on the first bank
  Vec3 pick = Vec3::Zero();  ///< the pick on the surface, length unit
  double length = 0;         ///< of the slit along the surface, as made; length unit
};

/// Opens a slit of the given length along the isoline of the director angle through the pick: theta
/// is a vertex's angle about the rod in its section's rest frame (d1, d2), and near the pick theta
/// = theta0 is where the signed distance to the half plane, y cos(theta0) - x sin(theta0), is zero;
/// no 2 pi jump there. Half the length lies on each side of the pick. `branch_of` (one label per
/// vertex, or empty) keeps the slit on the pick's branch; an empty one lets it run on where
/// `binding` continues one branch past a fork. The slit's rim has 2 n edges, the Euler number drops
/// by 1, and no edge made here is shorter than 5 % of the mean edge. Throws InputError when the
/// pick is more than `max_distance` off the surface, when the slit runs into an open end or a fork,
/// or when it is too short for the surface's triangles.
IncisionOutcome open_incision(const TriangleSurface& surface, const RodTree& rod,
                              const Binding& binding, const std::vector<int>& branch_of,
                              const Vec3& pick, double length, double max_distance);

}  // namespace vasorod
