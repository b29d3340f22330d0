// Options shared by all surface solvers. Each solver sets its own defaults and documents the
// reasons.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "numerics/solver_options.h"

namespace vasorod {

/// Tolerances, stiffnesses and limits of a surface solve.
struct SurfaceOptions : SolverOptions {
  /// On the solver's own residual, which the solver's options define.
  double tolerance = 1e-8;
  /// On BodySolution::residual.
  double balance_tolerance = 5e-7;
  /// On the largest seam gap over the radius of the mouth.
  double seam_tolerance = 1e-3;
  /// On the penetration over the mean edge.
  double contact_tolerance = 1e-3;
  /// On the slip of walls that stick between searches over the mean edge: so large a share of the
  /// pressure may be left as a force along the walls.
  double slip_tolerance = 1e-2;
  /// On the mean change of the pressures in the last multiplier update over their mean.
  double pressure_tolerance = 3e-3;
  /// k_j over the largest k_b or k_s of the joined bodies. Stiff enough to close the seam in two or
  /// three multiplier updates, soft enough for the preconditioner.
  double seam_stiffness = 100;
  /// Penalty times vertex area over k_b + k_s of the softer body.
  double contact_stiffness = 2;
  /// Multiplier updates.
  int max_outer = 100;
  /// Per minimisation between multiplier updates.
  int max_iterations = 3000;
  /// Of the true Hessian, per minimisation; 0: never.
  int max_factorisations = 40;
  /// Called before each ordering, which cannot be stopped inside, and each factorisation, with its
  /// name. May be empty.
  std::function<void(const std::string& step)> step;
  /// Determine the sign of the smallest curvature of the Hessian at the end.
  bool certify = false;

  /// Empty when the options are valid, else one sentence that names the invalid option.
  std::optional<std::string> is_invalid() const;
};

}  // namespace vasorod
