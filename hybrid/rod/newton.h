// Equilibrium of a rod tree: Newton on the mixed functional, soft start, energy descent as the
// fallback, certificate.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <vasorod/counts.h>
#include <vasorod/status.h>

#include "numerics/solver_options.h"
#include "rod/conditions.h"
#include "rod/rod_tree.h"

namespace vasorod {

/// Options of solve_rod().
struct RodOptions : SolverOptions {
  /// Stop when the largest step of any node (rotation in radians, translation over the rod's
  /// length) is below this value. Newton is quadratic there, so the remaining error is its square.
  /// A force criterion is not suitable, because its floor is eps E A.
  double tolerance = 1e-8;
  int max_iterations = 40;  ///< per Newton attempt; a successful attempt takes 5 to 15
  /// Follow the path of motions and loads in at least this many equal steps. 1: jump to the end,
  /// and follow the path only if that fails.
  int path_steps = 1;
  /// Leave a saddle along a negative direction; false: report the equilibrium found.
  bool leave_saddle = true;

  /// Empty when the options are valid, else one sentence that names the invalid option.
  std::optional<std::string> is_invalid() const;
};

/// Status, counts and certificate of a solve.
struct RodSummary {
  Status status = Status::iteration_limit;
  int iterations = 0;  ///< total number of linear solves
  /// Factorisations and solves, those of the certificate too. Forces and tangent are part of a
  /// factorisation, so that the others are 0.
  Counts counts;
  /// The larger of: out-of-balance nodal force over the largest force; misfit of strain and stress.
  double residual = 0;
  double last_step = 0;  ///< as in RodOptions::tolerance
  double energy = 0;     ///< elastic energy of the wall, stress * length^3
  /// Of the energy's Hessian at the result.
  int negative_directions = 0;
  /// Directions along which the energy does not change; symmetries if `converged`.
  int neutral_directions = 0;
  double seconds = 0;        ///< total wall-clock time, checks included
  double sweep_seconds = 0;  ///< part of it: linear solves and pose updates
  std::string message;       ///< one sentence beyond what the status says

  /// One line: status, counts, residual.
  std::string brief_report() const;
};

/// Force and moment of a support on the rod, about the node's current position, space axes.
struct RodReaction {
  int node = 0;
  Vec3 force = Vec3::Zero(), moment = Vec3::Zero(), center = Vec3::Zero();
};

/// Result of solve_rod(), in the units of the tree.
struct RodSolution {
  RodPoses poses;
  /// (n, m) per element, conjugate to its strain, body axes: of wall and lumen together.
  std::vector<Vec6> stress;
  std::vector<RodReaction> reactions;  ///< one per support, in their order
  RodSummary summary;
};

/// Solves for equilibrium. `start`: initial poses (an earlier solution); supports that moved since
/// then move these poses along. Throws InputError when the tree, the conditions or an option is
/// invalid.
RodSolution solve_rod(const RodTree& tree, const RodConditions& conditions,
                      const RodOptions& options = {}, const RodPoses* start = nullptr);

}  // namespace vasorod
