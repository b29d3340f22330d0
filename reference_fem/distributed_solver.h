// The distributed direct solver: MUMPS on a PETSc matrix to which every process adds the entries of
// its cells.
#pragma once

#include "reference_fem/linear_solver.h"

namespace vasorod::fem {

/// Symmetric matrices are factorised as L D L^T. The number of negative pivots (Sylvester's law of
/// inertia) shows whether they are positive definite on `multipliers` constraints: exactly that
/// many pivots are then negative.
std::unique_ptr<LinearSolver::Method> distributed_method(const Processes& processes);

}  // namespace vasorod::fem
