// Shared by the fidelities with surfaces: converts the prediction's vessels to bodies and back.
#pragma once

#include "bodies/body_problem.h"
#include "numerics/solver_options.h"
#include "predict/prediction.h"

namespace vasorod {

/// Bodies, seams and contact pairs of a prediction whose rods are solved.
BodyProblem body_problem(const Prediction& prediction);

/// Stores the solved surfaces in the prediction and its vessels. Records which vessels were left
/// out
/// (`what` says of what) and whether any touch.
void take_surfaces(SolvedSurfaces&& surfaces, const std::string& what, Prediction& prediction);

/// Reports a line of progress that begins with `what` every `every` iterations.
std::function<void(const SolverProgress&)> iteration_progress(const std::string& what, int every,
                                                              const SolveOptions& options);

/// The same before each step that cannot be stopped inside (SurfaceOptions::step).
std::function<void(const std::string&)> step_progress(const std::string& what,
                                                      const SolveOptions& options);

}  // namespace vasorod
