// Follows the equilibrium path from load 0 to 1 with Newton's method: tangent predictor in the
// first step, extrapolation afterwards. Steps are halved if Newton fails (det F <= 0, divergence,
// too many iterations) and grow if it converges easily. If short steps fail as well, the path
// continues in arc length (arc_length.h).
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <vasorod/counts.h>

#include "reference_fem/system.h"

namespace vasorod::fem {

/// Options of the path.
struct StepperOptions {
  /// First step, share of the load. A failed step costs its Newton iterations.
  double first_step = 0.1;
  /// Extrapolation over more than a quarter of a bend starts Newton too far from the solution.
  double largest_step = 0.25;
  double smallest_step = 1e-3;  ///< load steps end below this: a limit point, or the model's end
  /// Largest distance of Newton from its extrapolated guess, over the step. A larger distance means
  /// another branch: the step has failed. Unlimited by default, so that a kinking tube snaps
  /// through, as in an experiment; 0.7 follows the path.
  double largest_jump = 1e300;
  /// Steps in arc length after the load steps; 0: the path ends at its first limit point.
  int arc_steps = 300;
  /// Quadratic convergence takes 4 to 6 iterations; more than 14 mean that the step is too long.
  int max_iterations = 14;
  double tolerance = 1e-9;        ///< residual over the assembled size of the internal forces
  double loose_tolerance = 1e-6;  ///< accepted if rounding prevents further progress
  /// Factorise again at the end and report whether the tangent is positive definite.
  bool certify = true;
  std::vector<double> stops;          ///< loads to reach exactly (besides 1), increasing
  std::function<bool()> interrupted;  ///< called before each step; true ends the path
  /// Called after each converged step.
  std::function<void(double load, const State&, const System::Assembly&)> on_step;
};

/// How a path ended.
enum class PathStatus { complete, stuck, interrupted };
std::string to_string(PathStatus status);

/// Summary of a path.
struct StepperSummary {
  PathStatus status = PathStatus::complete;
  double load = 0;  ///< largest converged load, 0 to 1
  int steps = 0, iterations = 0, cutbacks = 0;
  std::vector<double> limit_loads;  ///< maxima of the load that were passed
  double relative_residual = 0, energy = 0;
  /// Of the tangent at the end; empty if its symmetry or size does not allow the test.
  std::optional<bool> positive_definite;
  double assembly_seconds = 0, factor_seconds = 0;
  Counts counts;  ///< `outer` stays 0
};

/// Follows the path. On return, `state` is the last converged state.
StepperSummary follow_path(const System& system, State& state, System::Assembly& assembly,
                           const StepperOptions& options = {});

}  // namespace vasorod::fem
