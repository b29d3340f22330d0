// Coarse before fine: the walls of an operation are solved on meshes with at most a quarter of the
// vertices, and the fine ones start where the coarse ones went. Most of the way, of the contacts
// found and of the factorisations that fail belong to the coarse walls, each for an eighth of the
// cost or less.
#pragma once

#include <optional>

#include "coupled/coupled_problem.h"
#include "predict/prediction.h"

namespace vasorod {

/// The operation of a prediction on coarser meshes, its rods solved. Empty without an
/// operation, where there are no such meshes, or where the operation fails on them.
std::optional<Prediction> coarse_prediction(const Prediction& fine, const SolveOptions& options);

/// Where the walls of the fine prediction are expected when those of the coarse one have moved to
/// `solution`.
CoupledStart start_from_coarse(const Prediction& coarse, const CoupledSolution& solution,
                               const Prediction& fine);

}  // namespace vasorod
