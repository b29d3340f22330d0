// The `skin` fidelity with a seam. Sections move rigidly; at a seam the surfaces deform as little
// as the paper's two quadratic energies require. Minimised is
//
//   k_c |p - p'|^2 [7] + k_b |l(p) - R l0(p)|^2 [8]
//
// with the two vertices of each pair identified. One linear solve. There is no stretching and no
// contact, so the result gives positions but no forces.
#pragma once

#include "bodies/body_problem.h"
#include "numerics/work.h"

namespace vasorod {

/// Positions of every body: p' (rest for a body without p'), changed only on bodies that a seam
/// joins. Fixed vertices stay at p'. The vertices of a pair coincide exactly. Throws InputError
/// when a coefficient is not positive. The linear solve is added to `work`, which may be null.
std::vector<Points> joined_skin(const BodyProblem& problem, Work* work = nullptr);

}  // namespace vasorod
