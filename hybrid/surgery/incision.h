// The incision of the Glenn operation: a slit parallel to the rod, its midpoint at the pick.
#pragma once

#include <array>
#include <vector>

#include <vasorod/types.h>

#include "geometry/vertex_source.h"
#include "rod/binding.h"
#include "rod/rod_tree.h"

namespace vasorod {

/// A vessel with an incision: a slit, or an ellipse that was taken out (ellipse.h).
struct IncisionOutcome {
  /// Opened; the input's vertices first (those that are left), new ones after.
  TriangleSurface surface;
  VertexSources sources;  ///< in the input surface
  /// The opening's boundary loop (the surface on its left), from the tip of smaller arc length s.
  std::vector<int> rim;
  int other_tip = 0;         ///< index into `rim` of the tip of larger s
  int middle = 0;            ///< slit: index into `rim` of the pick's vertex on the first bank
  Vec3 pick = Vec3::Zero();  ///< the pick on the surface, length unit
  double length = 0,         ///< actual length of the opening along the surface, length unit
      width = 0,             ///< ellipse: actual width on the surface, length unit
      perimeter = 0,         ///< of the rim, length unit
      removed_area = 0;      ///< ellipse: of the piece taken out, length unit^2
};

/// Opens a slit of the given length along the isoline of the director angle through the pick. theta
/// is a vertex's angle about the rod in the rest frame (d1, d2) of its section. Near the pick,
/// theta = theta0 is where the signed distance to the half plane,
/// y cos(theta0) - x sin(theta0), is zero; this function has no 2 pi jump. Half the length lies on
/// each side of the pick. `branch_of` (one label per vertex, or empty) keeps the slit on the pick's
/// branch; if it is empty, the slit continues where `binding` continues one branch past a fork. The
/// slit's rim has 2 n edges, the Euler number decreases by 1, and no new edge is shorter than 5 %
/// of the mean edge. `unit`: the length of `incision_length: 1` in the scene, for messages; 0 if
/// there is none. Throws InputError if the pick is more than `max_distance` off the surface, if
/// the slit runs into an open end or a fork, or if it is too short for the surface's triangles.
IncisionOutcome open_incision(const TriangleSurface& surface, const RodTree& rod,
                              const Binding& binding, const std::vector<int>& branch_of,
                              const Vec3& pick, double length, double max_distance,
                              double unit = 0);

}  // namespace vasorod
