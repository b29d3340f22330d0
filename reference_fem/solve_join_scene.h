// Solves a scene's join on one or more meshes, estimates the discretisation error, and puts the
// result together.
#pragma once

#include "reference_fem/solve_scene.h"

namespace vasorod::fem {

/// Throws InputError if the reference cannot solve the scene.
Result solve_join_scene(const Scene& scene, const SolveOptions& options);

}  // namespace vasorod::fem
