// The second half of the paper's order: surfaces carried, joined, pressed by what the rods did.
#pragma once

#include "app/options.h"
#include "app/prediction.h"

namespace vasorod {

/// Bodies, seams and contact pairs of a prediction whose rods are solved.
PaperProblem surface_problem(const Prediction& prediction);

/// Fidelity skin: sections carried rigidly, a seam closed by one linear solve.
void solve_skin(Prediction& prediction);

/// Fidelity paper: the paper's energies, joining springs and contact.
void solve_paper_surfaces(Prediction& prediction, const SolveOptions& options);

/// Hands the solved surfaces to the prediction and its vessels; says which were left out (`what` names them)
/// and whether any touch.
void take_surfaces(PaperSolution&& solution, const std::string& what, Prediction& prediction);

}  // namespace vasorod
