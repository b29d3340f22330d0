// Converts the solved stack to the bodies' forces, pressures and sums in the problem's units.
#pragma once

#include "bodies/surface_report.h"
#include "paper/paper_energy.h"

namespace vasorod {

/// The forces on each body in scaled units, term by term from the gradient of the energy at
/// `positions`.
std::vector<BodySolution> sum_forces(const ScaledBodies& scaled, const PaperSystem& system,
                                     const std::vector<int>& first, const Points& positions);

/// Largest BodySolution::residual.
double worst_balance(const std::vector<BodySolution>& bodies);

/// Fills the bodies, contacts, energies and seam gaps of `solution` in the problem's units.
/// `stacked` is the source of system.contacts. `final`: as in report_contacts().
void report_paper(const BodyProblem& problem, const ScaledBodies& scaled, const PaperSystem& system,
                  const std::vector<int>& first, const Points& positions,
                  const StackedContacts& stacked, BodyContacts& contacts, SurfaceSolution& solution,
                  bool final = true);

}  // namespace vasorod
