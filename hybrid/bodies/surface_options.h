// The options that every surface solver shares; each solver sets its own defaults and says why.
#pragma once

#include <optional>
#include <string>

#include "numerics/solver_options.h"

namespace vasorod {

struct SurfaceOptions : SolverOptions {
  double tolerance = 1e-8;          ///< on the solver's own residual; its options say which
  double balance_tolerance = 5e-7;  ///< on each body's |sum of forces| / its largest resultant
  double seam_tolerance = 1e-3;     ///< largest seam gap over the mouth's radius
  double contact_tolerance = 1e-3;  ///< penetration over the mean edge
  double pressure_tolerance =
      3e-3;  ///< change of the pressures by the last multiplier update, mean over mean
  double seam_stiffness =
      100;  ///< k_j over the largest k_b, k_s of the joined bodies: stiff enough to
            ///< close in two or three updates, soft enough for the preconditioner
  double contact_stiffness = 2;  ///< penalty times vertex area over k_b + k_s of the softer body
  int max_outer = 100;           ///< multiplier updates
  int max_iterations = 3000;     ///< per minimisation between multiplier updates
  int max_factorisations = 40;   ///< of the true Hessian, per minimisation; 0: never
  bool certify = false;  ///< ask for the sign of the Hessian's smallest curvature at the end

  /// Empty where the options are valid; else one sentence that says which is not.
  std::optional<std::string> is_invalid() const;
};

}  // namespace vasorod
