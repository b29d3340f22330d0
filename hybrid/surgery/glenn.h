// The Glenn operation on two prepared vessels in the rest configuration: cut the vein, place its
// rod, open the incision, pair mouth and rim.
#pragma once

#include <vasorod/scene.h>

#include "surgery/operation.h"
#include "vessel/end_conditions.h"
#include "vessel/prepared_vessel.h"

namespace vasorod {

/// Operates on `svc` and `rpa` in place: surfaces, arrays, rods and bindings become those after
/// surgery (remaining points in the input's order, then new ones). `svc_conditions` loses the ends
/// of the stump. It gains the pose of the mouth and, if the scene has no entry for the kept far
/// end, a clamp there. Throws InputError for picks more than a radius off their vessel, a cut that
/// leaves nothing, a tilt that leaves the vein, or an incision that does not fit.
Operation operate(const Scene& scene, const GlennSpec& spec, PreparedVessel& svc,
                  PreparedVessel& rpa, VesselConditions& svc_conditions,
                  const OperationOptions& options = {});

}  // namespace vasorod
