#include <algorithm>
#include <cmath>

#include "coupled/coupled_problem.h"
#include "data/sentence.h"

namespace vasorod {

CoupledOptions::CoupledOptions() {
  // Newton's last step is quadratic, so one more digit costs nothing.
  tolerance = 1e-9;
  // One multiplier update reaches it.
  seam_tolerance = 1e-4;
  slip_tolerance = 1e-3;
  // Each update gains a factor of the penalty over the wall's stiffness.
  pressure_tolerance = 1e-4;
  contact_stiffness = 10;
  max_factorisations = 100;
  // The true Hessian is factorised anyway.
  certify = true;
}

std::optional<std::string> CoupledOptions::is_invalid() const {
  if (auto fault = SurfaceOptions::is_invalid()) return fault;
  const auto positive = [](double value) { return std::isfinite(value) && value > 0; };
  const bool rising =
      !times.empty() && times.front() > 0 && times.back() == 1 &&
      std::adjacent_find(times.begin(), times.end(), [](double before, double after) {
        return !(before < after);
      }) == times.end();
  return first_fault({
      {positive(tie_tolerance), "tie_tolerance: expected a number above 0"},
      {positive(moment_tolerance), "moment_tolerance: expected a number above 0"},
      {positive(tie_stiffness), "tie_stiffness: expected a number above 0"},
      {hold_after >= 0, "hold_after: expected 0 or more"},
      {most_per_stage >= 0, "most_per_stage: expected 0 or more"},
      {rising, "times: expected rising numbers above 0, the last of them 1"},
  });
}

}  // namespace vasorod
