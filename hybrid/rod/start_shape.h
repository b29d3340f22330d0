// A starting shape for prescribed motions: the motions of the supports are distributed over the
// tree between them.
#pragma once

#include <vector>

#include "rod/link.h"

namespace vasorod {

/// Moves `poses` with the supports. `turn` (rotation vector per condition, space axes, may exceed a
/// full turn) and the target positions of the conditions are given. Rotations are distributed
/// harmonically along arc length and the elements turn with them; the remaining misfit at held
/// positions is distributed in the same way. `largest_turn`: largest rotation of any link, radians.
std::vector<Pose> start_shape(const std::vector<RodLink>& links,
                              const std::vector<NodeCondition>& conditions,
                              const std::vector<Vec3>& turn, const std::vector<Pose>& poses,
                              double* largest_turn = nullptr);

}  // namespace vasorod
