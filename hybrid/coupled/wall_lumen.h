// The lumen of a wall in a CoupledSystem, and the displacement that balances it at rest.
#pragma once

#include "coupled/coupled_problem.h"
#include "coupled/coupled_system.h"

namespace vasorod {

/// The lumen below a wall's inner face, closed at all open ends. `seam`: the vertices of a rim that
/// is joined to another wall, in order from the pair that both rims begin with; empty: none.
WallLumen wall_lumen(const WallInput& wall, const std::vector<HeldSection>& sections,
                     const std::vector<int>& seam, const LumenPressure& pressure);

/// The linear displacement under the pressure of the scan and the wall's axial prestretch, without
/// prestress, n x 3, length, for WallInput::prestress_displacement. All freedoms of `sections` are
/// held; their motions and loads are ignored. Throws InputError if nothing stops a rigid motion.
Points scan_displacement(const WallInput& wall, std::vector<HeldSection> sections,
                         double scan_pressure);

}  // namespace vasorod
