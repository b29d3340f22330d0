// What a Glenn operation leaves of its vein: one more obstacle of the scene.
#pragma once

#include "bodies/body_problem.h"
#include "predict/prediction.h"

namespace vasorod {

/// Appends the stump to the vessels, as an obstacle named NAME_stump at its place. Left out, with a
/// sentence in `left_out`, where a vessel at rest, or the axis of the joined vein, reaches into it
/// by more than half the vein's radius: so it is in sketches, while scanned neighbours overlap by
/// less. Vessels joined end to end have none: the other part is taken out or tied off, and the
/// joined one may lie there.
void add_stump(Prediction& prediction);

/// For contacts that a scene lists: what may touch the vein may touch its stump.
void touch_stump(const Prediction& prediction, BodyProblem& problem);

}  // namespace vasorod
