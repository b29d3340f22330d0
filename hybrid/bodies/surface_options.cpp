#include "bodies/surface_options.h"

#include <cmath>

namespace vasorod {

std::optional<std::string> SurfaceOptions::is_invalid() const {
  const auto positive = [](double value) { return std::isfinite(value) && value > 0; };
  return first_fault({
      {time_limit >= 0, "time_limit: expected a number of seconds of at least 0"},
      {positive(tolerance), "tolerance: expected a number above 0"},
      {positive(balance_tolerance), "balance_tolerance: expected a number above 0"},
      {positive(seam_tolerance), "seam_tolerance: expected a number above 0"},
      {positive(contact_tolerance), "contact_tolerance: expected a number above 0"},
      {positive(slip_tolerance), "slip_tolerance: expected a number above 0"},
      {positive(pressure_tolerance), "pressure_tolerance: expected a number above 0"},
      {positive(seam_stiffness), "seam_stiffness: expected a number above 0"},
      {positive(contact_stiffness), "contact_stiffness: expected a number above 0"},
      {max_outer >= 1, "max_outer: expected at least 1"},
      {max_iterations >= 1, "max_iterations: expected at least 1"},
      {max_factorisations >= 0, "max_factorisations: expected at least 0"},
  });
}

}  // namespace vasorod
