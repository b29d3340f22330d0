// Follows the equilibrium path from load 0 to 1 with Newton's method: tangent predictor on the
// first step, extrapolation afterwards, steps halved where Newton fails (det F <= 0, divergence,
// too many iterations) and grown where it is easy; where even short ones fail, on in arc length
// (arc_length.h).
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "reference_fem/system.h"

namespace vasorod::fem {

struct StepperOptions {
  double first_step =
      0.1;  ///< fraction of the load; the cost of a failed step is its Newton iterations
  double largest_step =
      0.25;  ///< extrapolation over more than a quarter of a bend starts Newton too far away
  double smallest_step = 1e-3;  ///< below this load steps end: a limit point, or the model's end
  /// Newton's way from its extrapolated guess, over the step: beyond it, another branch, and the
  /// step counts as failed. Unlimited by default: a kinking tube then snaps through, as in the
  /// hand; 0.7 follows the path.
  double largest_jump = 1e300;
  int arc_steps =
      300;  ///< steps in arc length after that; 0: the path ends at its first limit point
  int max_iterations =
      14;  ///< quadratic convergence needs 4 to 6; more than 14 means a step too long
  double tolerance = 1e-9;        ///< residual over the assembled size of the internal forces
  double loose_tolerance = 1e-6;  ///< accepted once rounding stops Newton from getting further
  bool certify =
      true;  ///< factorise once more at the end and say whether the tangent is positive definite
  std::vector<double> stops;          ///< loads the path must hit exactly (besides 1), increasing
  std::function<bool()> interrupted;  ///< asked before each step
  std::function<void(double load, const State&, const System::Assembly&)>
      on_step;  ///< after each converged step
};

enum class PathStatus { complete, stuck, interrupted };
std::string to_string(PathStatus status);

struct StepperSummary {
  PathStatus status = PathStatus::complete;
  double load = 0;  ///< largest converged load, 0 to 1
  int steps = 0, iterations = 0, cutbacks = 0;
  std::vector<double> limit_loads;  ///< maxima of the load that were passed
  double relative_residual = 0, energy = 0;
  std::optional<bool> positive_definite;  ///< tangent at the end; empty where its symmetry or size
                                          ///< does not allow the question
  double assembly_seconds = 0, factor_seconds = 0;
};

/// Returns the summary; `state` is the last converged state.
StepperSummary follow_path(const System& system, State& state, System::Assembly& assembly,
                           const StepperOptions& options = {});

}  // namespace vasorod::fem
