// The stress that vessels had when they were seen, before anything is cut.
#pragma once

#include <functional>
#include <string>

#include "predict/prediction.h"

namespace vasorod {

/// Throws InputError if the vessels of an operation, which joins them to one lumen, have different
/// pressures afterwards.
void require_one_pressure(const Scene& scene);

/// Fills PreparedVessel::prestress_displacement of the vessels with a pressure of the scan or an
/// axial prestretch, and adds a note for each pressure. `begin` is called before each vessel.
/// Throws InputError for a pressure that the wall cannot bear.
void prestress(Prediction& prediction, const std::function<void(const std::string&)>& begin);

}  // namespace vasorod
