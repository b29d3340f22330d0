// The stress that vessels had when they were seen, before anything is cut.
#pragma once

#include <functional>
#include <string>

#include "predict/fidelity.h"

namespace vasorod {

/// Throws InputError if the vessels of an operation, which joins them to one lumen, have different
/// pressures afterwards.
void require_one_pressure(const Scene& scene);

/// Gives the vessels with a pressure or an axial prestretch the stress they were seen with, in what
/// the fidelity's `lumen` says: fills PreparedVessel::prestress_displacement, or presses the rod,
/// or leaves it to the fidelity's solver. Adds a note for each pressure. `stop`: ends the search
/// for a shape without stress. `begin` is called before each vessel. Throws InputError for a
/// pressure that the wall cannot bear.
void prestress(Prediction& prediction, LumenOf lumen, const std::function<bool()>& stop,
               const std::function<void(const std::string&)>& begin);

/// The strain (WallEnergy::rms_prestrain) up to which the vessel's prestress is linear:
/// largest_linear_prestrain, or infinite of a vessel that stays as it was seen but for what touches
/// it, which is in equilibrium with either.
double linear_prestrain_up_to(const Scene& scene, const PredictedVessel& vessel);

}  // namespace vasorod
