// The distributed direct solver: MUMPS on a PETSc matrix to which every process adds its cells'
// entries.
#pragma once

#include "reference_fem/linear_solver.h"

namespace vasorod::fem {

/// Symmetric matrices are factorised as L D L^T, whose count of negative pivots (Sylvester's
/// inertia) says whether they are positive definite on `multipliers` constraints: exactly that many
/// are then negative.
std::unique_ptr<LinearSolver::Method> distributed_method(const Processes& processes);

}  // namespace vasorod::fem
