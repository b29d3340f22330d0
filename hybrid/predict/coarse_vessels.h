// The vessels of a scene with coarser meshes.
#pragma once

#include <vector>

#include "vessel/prepared_vessel.h"

namespace vasorod {

/// Vessels before an operation, with edges about twice as long, the same rods and the same order of
/// ends. Empty where those that deform have fewer than 8,000 vertices, whose factors cost little,
/// or where their coarser meshes could not show how they fold: an edge is then longer than 0.4
/// radii.
std::vector<PreparedVessel> coarse_vessels(const std::vector<PreparedVessel>& vessels);

}  // namespace vasorod
