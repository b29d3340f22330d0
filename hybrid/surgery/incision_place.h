// Where an incision is made: the pick on the wall, and what lies along the vessel.
#pragma once

#include <string>
#include <vector>

#include <vasorod/types.h>

#include "geometry/closest_point.h"
#include "rod/binding.h"
#include "rod/rod_tree.h"

namespace vasorod {

/// The pick on the wall.
struct IncisionPlace {
  std::string where;  ///< "incision at (x, y, z)", for messages
  ClosestPoint::Hit hit;
  std::vector<char> allowed;  ///< per vertex: it is on the pick's branch
};

/// Projects the pick on the wall. `branch_of`: one label per vertex, or empty. Throws InputError
/// for a pick more than `max_distance` off the surface, at an open end or at a fork.
IncisionPlace place_incision(const TriangleSurface& surface, const std::vector<int>& branch_of,
                             const Vec3& pick, double max_distance);

/// Arc length of every vertex's section from the rod's root, extended by z beyond the rod's ends;
/// length unit.
Eigen::VectorXd arc_length(const RodTree& rod, const Binding& binding);

/// Three digits, rounded down, so that a stated length fits.
std::string rounded_down(double length);

}  // namespace vasorod
