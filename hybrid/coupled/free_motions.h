// Checks that the sections of the walls, with the seams between them, stop every rigid motion.
#pragma once

#include "bodies/scaled_bodies.h"
#include "coupled/coupled_problem.h"

namespace vasorod {

/// Throws InputError (one sentence that names the vessel and its free rigid motion) when a modelled
/// body, together with all bodies joined to it, is free to move rigidly.
void check_free_motions(const CoupledProblem& problem, const ScaledBodies& scaled);

/// The same of one wall with `rest` (n x 3) that is held by these sections alone.
void check_free_motions(const std::string& name, const Points& rest,
                        const std::vector<HeldSection>& sections);

}  // namespace vasorod
