// The vessels of a scene with coarser meshes.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "vessel/prepared_vessel.h"

namespace vasorod {

/// Vessels before an operation, with the same rods and the same order of ends. Edges are about
/// twice as long, of vessels that are not among the `joined` four times, but not longer than 0.4
/// radii; those of obstacles twice. Empty where those that deform have fewer than 8,000 vertices,
/// whose factors cost little, or where edges twice as long could not show how they fold, being
/// longer than 0.4 radii.
std::vector<PreparedVessel> coarse_vessels(const std::vector<PreparedVessel>& vessels,
                                           const std::set<std::string>& joined);

}  // namespace vasorod
