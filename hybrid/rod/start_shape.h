// A starting shape for prescribed motions: what moves at the supports is spread over the tree
// between them.
#pragma once

#include <vector>

#include "rod/link.h"

namespace vasorod {

/// Poses carried along by what the supports do: `turn` (rotation vector, space axes, may exceed a
/// turn) and the target positions of the conditions, per condition. Rotations spread harmonically
/// along arc length, elements turn with them, and what then misses a held position is spread the
/// same way. `largest_turn`: of any link, radians.
std::vector<Pose> start_shape(const std::vector<RodLink>& links,
                              const std::vector<NodeCondition>& conditions,
                              const std::vector<Vec3>& turn, const std::vector<Pose>& poses,
                              double* largest_turn = nullptr);

}  // namespace vasorod
