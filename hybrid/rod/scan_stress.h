// The stress of a rod that is held in the shape it was seen in.
#pragma once

#include <vector>

#include "rod/conditions.h"

namespace vasorod {

/// Stress per element (wall and lumen together, body axes) of the linear equilibrium near the rest
/// shape, under the elements' lumen and natural strains. In the rest shape this stress balances
/// exactly: it is the first step of MULF (Gee, Foerster and Wall 2010) on the rod. The supports'
/// motions are ignored; they must stop every rigid motion.
std::vector<Vec6> scan_stress(const RodTree& tree, const RodConditions& conditions);

}  // namespace vasorod
