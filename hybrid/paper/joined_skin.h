// `skin` with a seam: sections are carried rigidly, and at a seam the surfaces give way as little
// as the paper's two quadratic energies ask: minimise k_c |p - p'|^2 [7] + k_b |l(p) - R l0(p)|^2
// [8] with paired vertices made one. One linear solve; no stretching, no contact, so it shows where
// things go and says nothing of forces.
#pragma once

#include "bodies/body_problem.h"

namespace vasorod {

/// Positions of every body: p' (rest where a body has none), changed only on bodies that a seam
/// joins. Fixed vertices stay at p'; a pair ends in one point exactly. Throws InputError when a
/// coefficient is not positive.
std::vector<Points> joined_skin(const BodyProblem& problem);

}  // namespace vasorod
