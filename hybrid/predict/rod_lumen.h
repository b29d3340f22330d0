// Pressure in the lumen and axial prestretch of the vessels' rods.
#pragma once

#include "predict/prediction.h"

namespace vasorod {

/// Gives a fitted vessel's rod the stress with which it was seen, and the pressure after: with
/// `after` equal to `scan` the rod stays as it is. `whole`: all its ends were held when it was
/// seen, not those alone that the scene names. Returns the largest strain along the circumference
/// that the change of pressure causes.
double press_rod(PreparedVessel& prepared, const VesselConditions& conditions, bool whole);

/// The force of the pressure on the lid that closes a rod's end, where a support carries it; else
/// zero.
Vec3 carried_lid(const PredictedVessel& vessel, int node);

/// The force of a support on the wall: without what it carries of the lid, as at `coupled`.
Vec3 force_on_wall(const PredictedVessel& vessel, const RodReaction& reaction);

}  // namespace vasorod
