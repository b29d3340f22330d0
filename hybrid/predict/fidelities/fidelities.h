// What each fidelity adds to a prediction whose rods are solved (Fidelity::solve).
#pragma once

#include "predict/prediction.h"

namespace vasorod {

/// The centerlines are all that is asked for.
void solve_rod_only(Prediction& prediction, const SolveOptions& options);

/// Sections carried rigidly, a seam closed by one linear solve.
void solve_skin(Prediction& prediction, const SolveOptions& options);

/// The paper's energies [7-9], joining springs and contact.
void solve_paper_surfaces(Prediction& prediction, const SolveOptions& options);

/// One minimum of walls, seams and contacts, started where the rods carry the sections. Gives every
/// moved vessel's rod the mean poses of its sections.
void solve_coupled(Prediction& prediction, const SolveOptions& options);

}  // namespace vasorod
