// From the solver's scaled state to what a caller reads: poses, stresses, reactions, energy,
// residual.
#pragma once

#include "rod/newton.h"
#include "rod/rod_problem.h"

namespace vasorod {

/// `summary` as the solver left it; residual and energy are added.
RodSolution report_solution(RodProblem& problem, const RodState& state, const RodSummary& summary);

}  // namespace vasorod
