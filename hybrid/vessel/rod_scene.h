// Bare rods of a scene (fidelity rod): from their pieces to a result.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "output/result.h"
#include "rod/newton.h"
#include "scene/scene.h"

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

/// The scene's bare rods, one assembly per root. With refine > 1 every element is cut into that many, nodes
/// of the unrefined rod at every refine-th station. Throws InputError (a sentence) where the rods cannot be
/// put together.
std::vector<RodAssembly> assemble_rods(const Scene& scene, int refine = 1);

struct RodSceneOptions {
  std::function<bool()> stop;  ///< asked once an iteration
};

/// Solves a scene whose vessels are bare rods; with Scene::extrapolate by Richardson on n and 2n elements,
/// order 4 instead of 2 in all that is reported at nodes. Fills everything of the result but `program`,
/// `environment` and the times of reading and writing.
Result solve_rod_scene(const Scene& scene, const RodSceneOptions& options = {});

}  // namespace vasorod
