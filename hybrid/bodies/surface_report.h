// From contacts and seams of a solved stack to pressures and gaps in the problem's units.
#pragma once

#include "bodies/body_contacts.h"
#include "bodies/joining_energy.h"
#include "bodies/surface_solution.h"

namespace vasorod {

/// Appends one entry per pair to solution.contacts and adds the pressures to solution.bodies. A
/// slave vertex' pressure is its multiplier's, a master vertex' the force handed to it over its
/// area. `stacked` is what `points` were made of.
void report_contacts(const BodyProblem& problem, const ScaledBodies& scaled,
                     const std::vector<ContactPoint>& points, const Points& positions,
                     const StackedContacts& stacked, BodyContacts& contacts,
                     SurfaceSolution& solution);

/// Largest and RMS gap of the seams.
void report_seam(const ScaledBodies& scaled, const std::vector<Join>& joins,
                 const Points& positions, SurfaceSolution& solution);

}  // namespace vasorod
