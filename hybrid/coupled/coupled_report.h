// Converts the solved system to forces, pressures, sections and sums in the problem's units.
#pragma once

#include "bodies/body_contacts.h"
#include "coupled/coupled_problem.h"
#include "coupled/coupled_system.h"

namespace vasorod {

/// Largest |sum of forces| / largest resultant or force of a section over the walls; 0 where all
/// are rounding errors.
double worst_coupled_balance(const ScaledBodies& scaled, const CoupledSystem& system,
                             const std::vector<int>& first_wall, const Eigen::VectorXd& z);

/// Fills surface, sections and energies of `solution`. `system` is null if nothing was modelled.
/// `first` and `first_wall` are each body's first vertex in the stack and its wall, -1 for a body
/// that is not among the unknowns. `final`: as in report_contacts().
void report_coupled(const CoupledProblem& problem, const ScaledBodies& scaled,
                    const CoupledSystem* system, const std::vector<int>& first,
                    const std::vector<int>& first_wall, const Eigen::VectorXd& z,
                    const StackedContacts& stacked, BodyContacts& contacts,
                    CoupledSolution& solution, bool final = true);

}  // namespace vasorod
