// Converts a solved join to the result's data, in the scene's axes and units.
#pragma once

#include <vasorod/result.h>

#include "reference_fem/join_solution.h"

namespace vasorod::fem {

/// Vessels, metrics, reactions, balances and the operation.
void report_join(const JoinProblem& problem, const JoinSolution& solution, Result& result);

/// The mouth, in the scene's units. The seam runs midway between rim and lips.
MouthReport join_mouth(const JoinProblem& problem, const JoinSolution& solution);

}  // namespace vasorod::fem
