// Converts the contacts and seams of a solved stack to pressures and gaps in the problem's units.
#pragma once

#include "bodies/body_contacts.h"
#include "bodies/crossing_guard.h"
#include "bodies/joining_energy.h"
#include "bodies/surface_solution.h"

namespace vasorod {

/// Appends one entry per pair to solution.contacts and adds the pressures to solution.bodies. The
/// pressure at a slave vertex comes from its own contact; the pressure at a master vertex is the
/// force transferred to the vertex over its area. `stacked` is the source of `points`. With
/// `final` false the contacts stay as they are, for a report on the way.
void report_contacts(const BodyProblem& problem, const ScaledBodies& scaled,
                     const std::vector<ContactPoint>& points, const Points& positions,
                     const StackedContacts& stacked, BodyContacts& contacts,
                     SurfaceSolution& solution, bool final = true);

/// Pressure of a guard's forces (n x 3) on the vertices of its surface, stress.
Eigen::VectorXd guard_pressure(const TriangleSurface& rest, const Points& force);

/// Stores the contact of a wall with itself that a guard keeps apart. `pressure`: of the guard, per
/// vertex, in the problem's unit; `gap`: the smallest of its faces, scaled length.
void report_guard(const ScaledBodies& scaled, const Eigen::VectorXd& pressure, double gap,
                  ContactSolution& pair);

/// Stores the largest and the RMS seam gap in `solution`, in the problem's length unit.
void report_seam(const ScaledBodies& scaled, const std::vector<Join>& joins,
                 const Points& positions, SurfaceSolution& solution);

}  // namespace vasorod
