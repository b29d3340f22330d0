// The work of each fidelity on a prediction whose rods are solved (Fidelity::solve).
#pragma once

#include "predict/prediction.h"

namespace vasorod {

/// Rods only: the centerlines are the result.
void solve_rod_only(Prediction& prediction, const SolveOptions& options);

/// Sections are carried rigidly; one linear solve closes a seam.
void solve_skin(Prediction& prediction, const SolveOptions& options);

/// The paper's energies [7-9], joining springs and contact.
void solve_paper_surfaces(Prediction& prediction, const SolveOptions& options);

/// One minimum of each vessel's wall as sections of harmonics, without contact. Every moved
/// vessel's rod gets the mean poses of its sections. Throws InputError (a sentence with the
/// vessel's place) for a vessel with branches or sections that are not star-shaped.
void solve_section(Prediction& prediction, const SolveOptions& options);

/// One minimum of walls, seams and contacts, started from sections carried by the rods. Every moved
/// vessel's rod gets the mean poses of its sections.
void solve_coupled(Prediction& prediction, const SolveOptions& options);

}  // namespace vasorod
