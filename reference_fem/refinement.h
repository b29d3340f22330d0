// The discretisation error of a value from two or three meshes: observed order, Richardson limit,
// grid convergence index (Roache; Celik et al., Journal of Fluids Engineering 130, 2008, 078001).
#pragma once

#include <optional>

namespace vasorod::fem {

/// An error estimate.
struct Convergence {
  std::optional<double> observed_order;  ///< three meshes with monotone changes
  /// The order used: the observed one if it is reliable, else min(observed, theory).
  double order = 0;
  /// Fs: 1.25 if the observed order agrees with theory within a tenth, else 3.
  double safety = 3;
  double uncertainty = 0;  ///< u_num = Fs |f2 - f1| / (r^p - 1), in the value's unit
};

/// `change` = |f1 - f2| between the finest two meshes, `coarse_change` = |f2 - f3| if there is a
/// third, `ratio` > 1 the refinement ratio, `theory` the order for smooth solutions. Signs do not
/// matter, so norms of fields may be given.
///
/// Two meshes give no observed order, and the solution is not smooth at a rigid section's rim.
/// Order 2 (or `theory`, if smaller) is then assumed with Fs = 3. Measured on a bent tube with
/// rigid ends: assuming 2 p = 6 is 1.5 times too optimistic.
Convergence grid_convergence(double change, std::optional<double> coarse_change, double ratio,
                             double theory);

}  // namespace vasorod::fem
