// Whether the sections of walls, with the seams between them, stop every rigid motion.
#pragma once

#include "bodies/scaled_bodies.h"
#include "coupled/coupled_problem.h"

namespace vasorod {

/// Throws InputError (one sentence naming the vessel and its free rigid motion) where a modelled
/// body, with all that is joined to it, could float away.
void check_free_motions(const CoupledProblem& problem, const ScaledBodies& scaled);

}  // namespace vasorod
