#include "reference_fem/refinement.h"

#include <algorithm>
#include <cmath>

namespace vasorod::fem {

Convergence grid_convergence(double change, std::optional<double> coarse_change, double ratio,
                             double theory) {
  Convergence out;
  out.order = std::min(theory, 2.0);
  if (coarse_change && change > 0 && *coarse_change > 0) {
    const double p = std::log(*coarse_change / change) / std::log(ratio);
    out.observed_order = p;
    if (std::abs(p - theory) <= 0.1 * theory) out.safety = 1.25;
    // no convergence observed: the estimate is the change itself, times Fs
    out.order = std::clamp(p, 0.5, theory);
  }
  out.uncertainty = out.safety * change / (std::pow(ratio, out.order) - 1);
  return out;
}

}  // namespace vasorod::fem
