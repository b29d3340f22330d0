// Equilibrium of a rod tree: Newton on the mixed functional, soft start, energy descent behind it,
// certificate.
#pragma once

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "rod/conditions.h"
#include "rod/rod_tree.h"

namespace vasorod {

enum class RodStatus {
  converged,         ///< equilibrium, Hessian positive definite (up to symmetries of the whole scene)
  equilibrium_only,  ///< equilibrium; not a certified minimum (a moment without energy, or a neutral
                     ///< direction)
  unstable,          ///< equilibrium with negative directions that could not be left, or were not to be
  iteration_limit,   ///< no equilibrium found; the poses are the best seen
  interrupted,       ///< stopped by the caller or the time limit
};
std::string to_string(RodStatus status);

struct RodOptions {
  /// Stop when the largest step of any node (rotation in radians, translation over the rod's length) is below
  /// this. Newton is quadratic there: what remains is its square. A force criterion would not do, its
  /// floor is eps E A.
  double tolerance = 1e-8;
  int max_iterations = 40;  ///< of one Newton attempt; one that works takes 5 to 15
  /// Follow the motions' and loads' path in at least this many equal steps. 1: jump, and follow only if that
  /// fails.
  int path_steps = 1;
  bool leave_saddle = true;  ///< go down a negative direction; false: report the equilibrium found
  double time_limit = std::numeric_limits<double>::infinity();  ///< seconds
  std::function<bool()> stop;                                   ///< asked once an iteration; true interrupts
};

struct RodSummary {
  RodStatus status = RodStatus::iteration_limit;
  int iterations = 0;  ///< linear solves in all
  double residual =
      0;  ///< largest of: out-of-balance nodal force over the largest force; misfit of strain and stress
  double last_step = 0;         ///< as in RodOptions::tolerance
  double energy = 0;            ///< elastic energy, stress * length^3
  int negative_directions = 0;  ///< of the energy's Hessian at the result
  int neutral_directions = 0;   ///< along which the energy does not change: symmetries where `converged`
  double seconds = 0;           ///< wall clock, all of it, checks included
  double sweep_seconds = 0;     ///< of that, linear solves and pose updates
  std::string message;          ///< one sentence; says what the status cannot
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

/// Solves for equilibrium. `start`: poses to begin from (an earlier solution); supports that moved carry them
/// along. Throws InputError when tree or conditions are wrong.
RodSolution solve_rod(const RodTree& tree, const RodConditions& conditions, const RodOptions& options = {},
                      const RodPoses* start = nullptr);

}  // namespace vasorod
