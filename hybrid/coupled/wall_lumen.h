// The lumen of a wall in a CoupledSystem.
#pragma once

#include "coupled/coupled_problem.h"
#include "coupled/coupled_system.h"

namespace vasorod {

/// The lumen below a wall's inner face, closed at all open ends. `seam`: the vertices of a rim that
/// is joined to another wall, in order from the pair that both rims begin with; empty: none.
WallLumen wall_lumen(const WallInput& wall, const std::vector<HeldSection>& sections,
                     const std::vector<int>& seam, const LumenPressure& pressure);

}  // namespace vasorod
