// One scene solved with the hybrid model, in the paper's order: rods first, surfaces second.
#pragma once

#include "app/options.h"
#include "output/result.h"

namespace vasorod {

/// Throws InputError on what the scene asks and this program does not do.
Result solve_scene(const Scene& scene, const SolveOptions& options);

}  // namespace vasorod
