// Converts the solver's scaled state to the reported quantities: poses, stresses, reactions,
// energy, residual.
#pragma once

#include "rod/newton.h"
#include "rod/rod_problem.h"

namespace vasorod {

/// `summary` comes from the solver; residual and energy are added to it.
RodSolution report_solution(RodProblem& problem, const RodState& state, const RodSummary& summary);

}  // namespace vasorod
