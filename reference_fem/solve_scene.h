// Solves a scene with the reference on one or more meshes and estimates the discretisation error
// from the last two or three.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include <vasorod/result.h>

#include "reference_fem/tube_problem.h"

namespace vasorod::fem {

/// How a scene is solved.
struct SolveOptions {
  ModelKind model = ModelKind::solid;
  std::optional<LawKind> law;  ///< empty: the scene's
  int degree = 3;              ///< 1 and 2 lock on thin tubes; 3 and 4 do not
  /// Refinements by 3/2 after the first mesh: 0 gives no error estimate, 2 an observed order.
  int refine = 1;
  /// Cells of the first mesh around and along the tube, around the seam and along the vein of a
  /// join. Multiples of 4; around 0: 8, of a join 16; along 0: as large as those around.
  int around = 0, along = 0;
  std::string mesh;     ///< a gmsh file replaces `around` x `along`; refined by halving its cells
  Processes processes;  ///< the processes that solve together
  StepperOptions stepper;
  std::function<void(const std::string&)> progress;  ///< called with a line for the terminal
};

/// Throws InputError if the reference cannot solve the scene. If a path ends early, the result
/// holds the last converged state.
Result solve_scene(const Scene& scene, const SolveOptions& options);

}  // namespace vasorod::fem
