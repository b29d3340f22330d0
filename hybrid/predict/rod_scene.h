// Solves the bare rods of a scene (fidelity rod): from their pieces to a result.
#pragma once

#include <string>
#include <vector>

#include <vasorod/predict.h>

#include "rod/newton.h"

namespace vasorod {

/// One rod with all rods that branch off it, for the solver.
struct RodAssembly {
  RodTree tree;
  RodConditions conditions;
  std::vector<std::string> vessels;  ///< per branch of the tree

  /// A place named in `ends:`. Entries of the scene for the same place share it.
  struct End {
    std::string vessel, name;  ///< name: as in the result
    int node = 0;
    int support = -1;  ///< index into conditions.supports
  };
  std::vector<End> ends;
};

/// The scene's bare rods, one assembly per root. With refine > 1, every element is divided into
/// that many; every refine-th node is a node of the unrefined rod. Throws InputError (a sentence)
/// if the rods cannot be assembled.
std::vector<RodAssembly> assemble_rods(const Scene& scene, int refine = 1);

/// Solves a scene whose vessels are bare rods. With Scene::extrapolate, Richardson extrapolation
/// from n and 2n elements gives order 4 instead of 2 for all values at nodes. The result has no
/// hashes of the inputs.
Result solve_rod_scene(const Scene& scene, const SolveOptions& options = {});

}  // namespace vasorod
