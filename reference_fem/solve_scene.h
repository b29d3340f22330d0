// A scene solved by the reference on one or more meshes, with the numerical error the last two or
// three of them show.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include <vasorod/result.h>

#include "reference_fem/tube_problem.h"

namespace vasorod::fem {

struct SolveOptions {
  ModelKind model = ModelKind::solid;
  std::optional<LawKind> law;  ///< absent: the scene's
  int degree = 3;              ///< 1 and 2 lock on thin tubes; 3 and 4 do not
  int refine = 1;  ///< refinements by 3/2 after the first mesh: 0 gives no error estimate, 2 an
                   ///< observed order
  int around = 8,
      along = 0;        ///< cells of the first mesh, multiples of 4; along 0: nearly square cells
  std::string mesh;     ///< a gmsh file instead of `around` x `along`; refined by halving its cells
  Processes processes;  ///< the processes that solve together
  StepperOptions stepper;
  std::function<void(const std::string&)> progress;  ///< a line for the terminal
};

/// Throws InputError for what the reference cannot do. Where a path ends early the result holds the
/// last converged state.
Result solve_scene(const Scene& scene, const SolveOptions& options);

}  // namespace vasorod::fem
