#include "reference_fem/prestress.h"

#include <algorithm>

#include <vasorod/error.h>

namespace vasorod::fem {

Eigen::VectorXd seen_displacement(VesselModel& intact, const SeenState& seen, Supports supports,
                                  const Processes& processes) {
  for (Section& section : supports.sections) {
    section.fixed.fill(true);
    section.move = section.rotation = section.force = section.moment = Vec3::Zero();
  }
  intact.set_pressure({0, seen.pressure.scan});
  const System system(intact, std::move(supports), processes);
  const State rest = system.rest();
  State state = rest;
  system.prescribe(state, 1);
  System::Assembly stiffness, load;
  system.assemble(rest, 0, true, stiffness, &state);
  intact.set_prestress(seen.axial_stretch, Eigen::VectorXd::Zero(intact.dof_count()));
  system.assemble(rest, 1, false, load);
  LinearSolver solver(processes);
  if (!solver.factor(stiffness.tangent, true, system.multipliers()))
    throw InputError(
        "nothing holds a vessel against the pressure of its scan, expected a held end");
  system.add(state, -solver.solve(stiffness.residual + load.residual));
  intact.set_pressure({});
  return state.u;
}

double largest_displacement(const Eigen::VectorXd& u, int components) {
  double largest = 0;
  for (Eigen::Index first = 0; first < u.size(); first += components)
    largest = std::max(largest, u.segment<3>(first).norm());
  return largest;
}

}  // namespace vasorod::fem
