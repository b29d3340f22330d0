// Bare rods of a scene (fidelity rod): from their pieces to a result.
#pragma once

#include <string>
#include <vector>

#include <vasorod/predict.h>

#include "rod/newton.h"

namespace vasorod {

/// One rod with all that branches off it, as the solver sees it.
struct RodAssembly {
  RodTree tree;
  RodConditions conditions;
  std::vector<std::string> vessels;  ///< per branch of the tree

  /// A place that `ends:` names; entries of the scene for one place share it.
  struct End {
    std::string vessel, name;  ///< name: as in the result
    int node = 0;
    int support = -1;  ///< index into conditions.supports
  };
  std::vector<End> ends;
};

/// The scene's bare rods, one assembly per root. With refine > 1 every element is cut into that
/// many, nodes of the unrefined rod at every refine-th station. Throws InputError (a sentence)
/// where the rods cannot be put together.
std::vector<RodAssembly> assemble_rods(const Scene& scene, int refine = 1);

/// Solves a scene whose vessels are bare rods; with Scene::extrapolate by Richardson on n and 2n
/// elements, order 4 instead of 2 in all that is reported at nodes. Everything but the hashes of
/// the inputs.
Result solve_rod_scene(const Scene& scene, const SolveOptions& options = {});

}  // namespace vasorod
