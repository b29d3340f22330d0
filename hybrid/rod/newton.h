// Equilibrium of a rod tree: Newton on the mixed functional, soft start, energy descent behind it,
// certificate.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <vasorod/status.h>

#include "numerics/solver_options.h"
#include "rod/conditions.h"
#include "rod/rod_tree.h"

namespace vasorod {

struct RodOptions : SolverOptions {
  /// Stop when the largest step of any node (rotation in radians, translation over the rod's
  /// length) is below this. Newton is quadratic there: what remains is its square. A force
  /// criterion would not do, its floor is eps E A.
  double tolerance = 1e-8;
  int max_iterations = 40;  ///< of one Newton attempt; one that works takes 5 to 15
  /// Follow the motions' and loads' path in at least this many equal steps. 1: jump, and follow
  /// only if that fails.
  int path_steps = 1;
  bool leave_saddle = true;  ///< go down a negative direction; false: report the equilibrium found

  /// Empty where the options are valid; else one sentence that says which is not.
  std::optional<std::string> is_invalid() const;
};

struct RodSummary {
  Status status = Status::iteration_limit;
  int iterations = 0;    ///< linear solves in all
  double residual = 0;   ///< largest of: out-of-balance nodal force over the largest force; misfit
                         ///< of strain and stress
  double last_step = 0;  ///< as in RodOptions::tolerance
  double energy = 0;     ///< elastic energy, stress * length^3
  int negative_directions = 0;  ///< of the energy's Hessian at the result
  int neutral_directions =
      0;               ///< along which the energy does not change: symmetries where `converged`
  double seconds = 0;  ///< wall clock, all of it, checks included
  double sweep_seconds = 0;  ///< of that, linear solves and pose updates
  std::string message;       ///< one sentence; says what the status cannot

  /// One line: status, counts, residual.
  std::string brief_report() const;
};

/// What a support does to the rod, about the node's current position.
struct RodReaction {
  int node = 0;
  Vec3 force = Vec3::Zero(), moment = Vec3::Zero(), center = Vec3::Zero();
};

struct RodSolution {
  RodPoses poses;
  std::vector<Vec6> stress;            ///< (n, m) per element, conjugate to its strain, body axes
  std::vector<RodReaction> reactions;  ///< one per support, in their order
  RodSummary summary;
};

/// Solves for equilibrium. `start`: poses to begin from (an earlier solution); supports that moved
/// carry them along. Throws InputError when tree or conditions are wrong.
RodSolution solve_rod(const RodTree& tree, const RodConditions& conditions,
                      const RodOptions& options = {}, const RodPoses* start = nullptr);

}  // namespace vasorod
