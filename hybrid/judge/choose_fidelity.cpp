#include "judge/choose_fidelity.h"

#include <algorithm>
#include <cmath>

#include <vasorod/error.h>

#include "data/scene_place.h"
#include "data/sentence.h"
#include "geometry/triangle_surface.h"
#include "judge/validity.h"
#include "rod/conditions.h"
#include "rod/strain_change.h"

namespace vasorod {
namespace {

// Treats the round-off of an absent load as zero.
std::string digits(double value) {
  return number_text(std::abs(value) < 1e-9 ? 0 : value, 3);
}

// The table's fidelities, from cheap to expensive.
std::vector<std::string> fidelities_of(std::span<const AccuracyRow> table) {
  std::vector<std::string> names;
  for (const AccuracyRow& row : table)
    if (names.empty() || names.back() != row.fidelity) names.emplace_back(row.fidelity);
  return names;
}

Demand demand_of(const RodOfVessel& rod) {
  const Vessel& vessel = rod.vessel->vessel;
  Validity validity;
  add_validity(*rod.vessel, *rod.poses, {.rigid_nodes = rod.rigid_nodes}, validity);
  Demand demand;
  demand.twist = validity.twist_ratio;
  demand.bend = validity.wrinkling_ratio;
  for (const ElementChange& change : element_changes(vessel.rod, *rod.poses))
    demand.stretch = std::max(demand.stretch, std::abs(change.change[2]));
  demand.edge = mean_edge_length(vessel.surface) / vessel.mean_radius;
  return demand;
}

// Why the table does not cover this scene; empty if it does.
std::string outside_of_table(const Scene& scene, const std::vector<RodOfVessel>& rods) {
  if (scene.joined()) return "the table is of single tubes, not of operations";
  for (const VesselSpec& vessel : scene.vessels)
    if (vessel.pressure || vessel.axial_prestretch != 1)
      return "the table is of tubes without a pressure or a prestretch";
  if (scene.vessels.size() != 1 || rods.size() != 1)
    return "the table is of single tubes, not of several vessels";
  const PreparedVessel& prepared = *rods.front().vessel;
  const Vessel& vessel = prepared.vessel;
  if (vessel.rod.branches.size() != 1) return "the table is of tubes without branches";
  // One that is soft in shear bends otherwise beside its ends, which `section` does not know.
  if (prepared.spec.wall && !prepared.spec.wall->material.is_isotropic())
    return "the table is of isotropic walls";
  const AccuracyScope scope = accuracy_scope();
  const double tolerance = 0.01, thickness = prepared.thickness() / vessel.mean_radius,
               length = length_scale(vessel.rod) / vessel.mean_radius;
  const auto outside = [&](double value, const std::array<double, 2>& range) {
    return value < range[0] * (1 - tolerance) || value > range[1] * (1 + tolerance);
  };
  if (outside(thickness, scope.thickness))
    return "the table is of walls with t/R " + digits(scope.thickness[0]) + " to " +
           digits(scope.thickness[1]) + ", this one has " + digits(thickness);
  if (outside(length, scope.length))
    return "the table is of tubes with L/R " + digits(scope.length[0]) + " to " +
           digits(scope.length[1]) + ", this one has " + digits(length);
  for (const ElementChange& change : element_changes(vessel.rod, *rods.front().poses)) {
    // The table was measured on pulled tubes. It does not cover walls close to wrinkling, at a
    // strain of -0.605 t / R.
    if (change.change[2] < -0.1 * 0.605 * thickness)
      return "the table is of tubes that are not pressed";
    // With a rest curvature of a hundredth of the local wrinkling curvature, a section already
    // flattens to first order.
    if ((change.strain - change.change).segment<2>(3).norm() * vessel.mean_radius >
        0.01 * 0.605 * thickness)
      return "the table is of tubes that are straight at rest";
  }
  return {};
}

}  // namespace

std::optional<double> promised_error(std::span<const AccuracyRow> table, std::string_view fidelity,
                                     const Demand& demand) {
  double sum = 0;
  for (const auto& [kind, wanted] :
       {std::pair(LoadKind::stretch, demand.stretch), std::pair(LoadKind::twist, demand.twist),
        std::pair(LoadKind::bend, demand.bend)}) {
    const auto belongs = [&, k = kind](const AccuracyRow& row) {
      return row.fidelity == fidelity && row.kind == k && row.edge >= demand.edge * (1 - 1e-9);
    };
    double edge = INFINITY;  // the finest tabulated mesh that is not finer than the scene's mesh
    for (const AccuracyRow& row : table)
      if (belongs(row)) edge = std::min(edge, row.edge);
    double demand_before = 0, error_before = 0;
    bool reached = false;
    for (const AccuracyRow& row : table) {
      if (!belongs(row) || row.edge != edge || reached) continue;
      if (wanted <= row.demand * (1 + 1e-6)) {  // tolerates round-off at the last row
        sum += error_before +
               (row.error - error_before) * (wanted - demand_before) / (row.demand - demand_before);
        reached = true;
      }
      demand_before = row.demand;
      error_before = row.error;
    }
    if (!reached) return std::nullopt;
  }
  return sum;
}

std::string FidelityChoice::sentence() const {
  return "accuracy " + digits(wanted) + " of R: " + fidelity +
         (promised ? ", promised to be within " + digits(*promised) : "") + ": " + reason;
}

FidelityChoice choose_fidelity(const Scene& scene, const std::vector<RodOfVessel>& rods,
                               const std::string& dearest, std::span<const AccuracyRow> table) {
  FidelityChoice choice;
  choice.wanted = *scene.accuracy;
  std::string reason = outside_of_table(scene, rods);
  if (reason.empty()) {
    const Demand demand = demand_of(rods.front());
    const std::string load = "stretch " + digits(demand.stretch) + ", twist ratio " +
                             digits(demand.twist) + ", bend ratio " + digits(demand.bend) +
                             ", edge/R " + digits(demand.edge);
    std::optional<double> best;
    for (const std::string& fidelity : fidelities_of(table)) {
      const auto error = promised_error(table, fidelity, demand);
      if (!error) continue;
      if (*error <= choice.wanted) {
        choice.fidelity = fidelity;
        choice.promised = *error;
        choice.reason = "the cheapest the measured table promises to be within " +
                        digits(choice.wanted) + " of R at " + load;
        return choice;
      }
      best = std::min(best.value_or(INFINITY), *error);
    }
    if (best)
      throw InputError(place_in(scene) + ": accuracy: found " + digits(choice.wanted) +
                       ", expected " + digits(*best) +
                       " or more: nothing is promised to be nearer to finite elements at " + load);
    reason = "the table does not reach to " + load;
  }
  choice.fidelity = dearest;
  choice.reason = "the dearest, without a promise: " + reason;
  return choice;
}

}  // namespace vasorod
