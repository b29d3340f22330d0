// Fidelity coupled: one minimum of walls, seams and contacts, started where the solved rods carry the
// sections.
#pragma once

#include "app/options.h"
#include "app/prediction.h"

namespace vasorod {

/// Solves the walls and gives every moved vessel's rod the mean poses of its sections. Throws InputError.
void solve_coupled(Prediction& prediction, const SolveOptions& options);

}  // namespace vasorod
