// The bodies of a prediction as their rods carry them on a path.
#pragma once

#include <vector>

#include "bodies/body_problem.h"
#include "bodies/seam_way.h"
#include "predict/joining_path.h"
#include "predict/prediction.h"
#include "predict/vessel_wall.h"

namespace vasorod {

/// The bodies at time t of the path, with their `sections` (of each vessel; may be empty ones).
/// `way`: the vein goes along it; null: it goes by a share of its rod's strain as all others do.
std::vector<CarriedBody> carried_by_rods(const Prediction& prediction,
                                         const std::vector<VesselSections>& sections, double t,
                                         const JoiningPath* way);

/// The vein of an operation and the artery that it is joined to touch themselves.
void feel_themselves(const Prediction& prediction, BodyProblem& problem);

/// The vein of an operation starts at rest and goes to its seam: the way of the seam.
SeamWay start_at_rest(const Prediction& prediction, const std::shared_ptr<const JoiningPath>& way,
                      BodyProblem& problem);

}  // namespace vasorod
