// From the solved stack to the bodies' forces, pressures and sums in the problem's units.
#pragma once

#include "surface/paper_contacts.h"
#include "surface/paper_energy.h"

namespace vasorod {

/// The forces on each body, scaled units, term by term from the energy's gradient at `positions`.
std::vector<BodySolution> sum_forces(const ScaledBodies& scaled, const PaperSystem& system,
                                     const std::vector<int>& first, const Points& positions);

/// Largest BodySolution::residual.
double worst_balance(const std::vector<BodySolution>& bodies);

/// Appends one entry per pair to solution.contacts and adds the pressures to solution.bodies. A slave vertex'
/// pressure is its multiplier's, a master vertex' the force handed to it over its area. `stacked` is what
/// `points` were made of.
void report_contacts(const PaperProblem& problem, const ScaledBodies& scaled,
                     const std::vector<ContactPoint>& points, const Points& positions,
                     const StackedContacts& stacked, PaperContacts& contacts, PaperSolution& solution);

/// Largest and RMS gap of the seams.
void report_seam(const ScaledBodies& scaled, const std::vector<Join>& joins, const Points& positions,
                 PaperSolution& solution);

/// Fills the bodies, contacts, energies and seam gaps of `solution`, in the problem's units. `stacked` is
/// what system.contacts was made of.
void report_paper(const PaperProblem& problem, const ScaledBodies& scaled, const PaperSystem& system,
                  const std::vector<int>& first, const Points& positions, const StackedContacts& stacked,
                  PaperContacts& contacts, PaperSolution& solution);

}  // namespace vasorod
