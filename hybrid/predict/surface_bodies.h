// What the fidelities with surfaces share: the prediction's vessels as bodies, and the way back.
#pragma once

#include "bodies/body_problem.h"
#include "numerics/solver_options.h"
#include "predict/prediction.h"

namespace vasorod {

/// Bodies, seams and contact pairs of a prediction whose rods are solved.
BodyProblem body_problem(const Prediction& prediction);

/// Hands the solved surfaces to the prediction and its vessels. Says which were left out (`what`
/// names them) and whether any touch.
void take_surfaces(SolvedSurfaces&& surfaces, const std::string& what, Prediction& prediction);

/// Every so many iterations a line of progress that begins with `what`.
std::function<void(const SolverProgress&)> iteration_progress(const std::string& what, int every,
                                                              const SolveOptions& options);

}  // namespace vasorod
