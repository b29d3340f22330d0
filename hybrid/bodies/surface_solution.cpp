#include "bodies/surface_solution.h"

#include "data/sentence.h"

namespace vasorod {

std::string SurfaceSolution::brief_report() const {
  std::string line = to_string(status) + ": residual " + number_text(residual) + " after " +
                     std::to_string(iterations) + " iterations, " +
                     std::to_string(outer_iterations) + " multiplier updates, " +
                     std::to_string(work.counts.factorisations) + " factorisations";
  if (seam_radius > 0)
    line += ", largest seam gap " + number_text(largest_seam_gap / seam_radius) +
            " of the mouth's radius";
  return line;
}

}  // namespace vasorod
