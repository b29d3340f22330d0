#include "reference_fem/prestress.h"

#include <algorithm>

#include <vasorod/error.h>

#include "numerics/stress_free_search.h"

namespace vasorod::fem {
namespace {

double largest_displacement(const Eigen::VectorXd& u, int components) {
  double largest = 0;
  for (Eigen::Index first = 0; first < u.size(); first += components)
    largest = std::max(largest, u.segment<3>(first).norm());
  return largest;
}

// One vessel held as it was seen.
class SeenVessel final : public StressFreeProblem {
 public:
  SeenVessel(VesselModel& model, const SeenState& seen, Supports supports,
             const Processes& processes)
      : model_(model),
        seen_(seen),
        system_(model, std::move(supports), processes),
        solver_(processes),
        rest_(system_.rest()) {
    origin_ = rest_;
    system_.prescribe(origin_, 1);
  }

  // Unknowns of the linear displacement and of its sections' multipliers.
  Eigen::VectorXd linear() {
    System::Assembly stiffness, load;
    system_.assemble(rest_, 0, true, stiffness, &origin_);
    model_.set_prestress(seen_.axial_stretch, Eigen::VectorXd::Zero(model_.dof_count()));
    system_.assemble(rest_, 1, false, load);
    if (!solver_.factor(stiffness.tangent, true, system_.multipliers()))
      throw InputError(
          "nothing holds a vessel against the pressure of its scan, expected a held end");
    return -solver_.solve(stiffness.residual + load.residual);
  }

  bool set(double share, const Eigen::VectorXd& unknowns) override {
    model_.set_pressure({0, share * seen_.pressure.scan});
    origin_ = rest_;
    system_.prescribe(origin_, share);
    const bool shaped =
        model_.set_stress_free_shape(1 + share * (seen_.axial_stretch - 1), displacement(unknowns));
    return !system_.processes().any(!shaped);
  }

  Eigen::VectorXd step(const Eigen::VectorXd& unknowns) override {
    State seen = rest_;
    seen.multiplier = state(unknowns).multiplier;
    System::Assembly assembly;
    system_.assemble(seen, 1, false, assembly);
    return -solver_.solve(assembly.residual);
  }

  double length(const Eigen::VectorXd& unknowns) const override {
    State moved = rest_;
    system_.add(moved, unknowns);
    return largest_displacement(moved.u, model_.components());
  }

  Eigen::VectorXd displacement(const Eigen::VectorXd& unknowns) const { return state(unknowns).u; }

 private:
  State state(const Eigen::VectorXd& unknowns) const {
    State out = origin_;
    system_.add(out, unknowns);
    return out;
  }

  VesselModel& model_;
  const SeenState& seen_;
  System system_;
  LinearSolver solver_;
  State rest_, origin_;  // as seen; with what is prescribed of u
};

}  // namespace

SeenDisplacement seen_displacement(VesselModel& intact, const SeenState& seen, Supports supports,
                                   double largest_linear, const Processes& processes) {
  for (Section& section : supports.sections) {
    section.fixed.fill(true);
    section.move = section.rotation = section.force = section.moment = Vec3::Zero();
  }
  intact.set_pressure({0, seen.pressure.scan});
  SeenVessel vessel(intact, seen, std::move(supports), processes);
  Eigen::VectorXd unknowns = vessel.linear();
  SeenDisplacement found;
  found.u = vessel.displacement(unknowns);
  found.largest = largest_displacement(found.u, intact.components());
  if (intact.rms_prestrain(seen.axial_stretch, found.u, processes) > largest_linear) {
    found.steps = search_stress_free(vessel, unknowns);
    vessel.set(1, unknowns);  // what is prescribed too
    found.u = vessel.displacement(unknowns);
    found.largest = largest_displacement(found.u, intact.components());
  }
  intact.set_pressure({});
  return found;
}

void give_prestress(VesselModel& model, const SeenState& seen, const SeenDisplacement& found,
                    const Processes& processes) {
  if (!(found.steps > 0)) {
    model.set_prestress(seen.axial_stretch, found.u);
    return;
  }
  const bool shaped = model.set_stress_free_shape(seen.axial_stretch, found.u);
  if (processes.any(!shaped))
    throw InputError(
        "the shape without stress of a vessel, as the pressure of its scan and its "
        "axial_prestretch make it, is turned inside out, expected less of both");
}

}  // namespace vasorod::fem
