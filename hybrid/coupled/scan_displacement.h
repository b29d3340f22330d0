// The displacement whose stress balances a wall as it was seen (WallInput::prestress_displacement).
#pragma once

#include <functional>
#include <optional>

#include "coupled/coupled_problem.h"

namespace vasorod {

struct ScanDisplacement {
  Points points;                        ///< n x 3, length
  bool from_stress_free_shape = false;  ///< as in WallInput
  /// In which the shape without stress was found; 0: it was not; empty: it was not looked for.
  std::optional<int> steps;
};

/// Under the pressure of the scan and the wall's axial prestretch. All freedoms of `sections` are
/// held; their motions and loads are ignored. It is the linear displacement without prestress where
/// its strain (WallEnergy::rms_prestrain) is at most `largest_linear`. Beyond, it leads from the
/// shape without stress, of which the wall under both is in equilibrium as it was seen, and which
/// is looked for in steps; should it not be found, or `stop` say so, it is the linear one all the
/// same. Throws InputError if nothing stops a rigid motion.
ScanDisplacement scan_displacement(const WallInput& wall, std::vector<HeldSection> sections,
                                   double scan_pressure, double largest_linear,
                                   const std::function<bool()>& stop = {});

}  // namespace vasorod
