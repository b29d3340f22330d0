#include "predict/result_of_prediction.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "data/index.h"
#include "data/sentence.h"
#include "geometry/triangle_surface.h"
#include "judge/mouth.h"
#include "judge/validity.h"
#include "predict/result_of_vessel.h"
#include "predict/result_parts.h"
#include "predict/rod_lumen.h"
#include "rod/conditions.h"

namespace vasorod {
namespace {

void add_rods(const Prediction& prediction, Result& result) {
  const bool start_only = prediction.surfaces && prediction.surfaces->carry_everything;
  for (const PredictedVessel& vessel : prediction.vessels) {
    if (!vessel.rod_solved) continue;
    if (start_only) {
      result.iterations["rod"] += vessel.rod.summary.iterations;
      continue;
    }
    const std::string& name = vessel.prepared.spec.name;
    add_rod(name, vessel.rod.summary, !prediction.surfaces, result);
    for (const ConditionedEnd& end : vessel.conditions.ends) {
      const int node = vessel.prepared.vessel.ends[index(end.end)].node;
      for (const RodReaction& reaction : vessel.rod.reactions)
        if (reaction.node == node)
          result.ends.push_back(
              {name, end.label, force_on_wall(vessel, reaction), reaction.moment, reaction.center});
    }
  }
}

void add_surfaces(const SolvedSurfaces& surfaces, Result& result) {
  const SurfaceSolution& solution = surfaces.solution;
  result.status = worse(result.status, solution.status);
  result.certificate.relative_residual =
      worst_of(result.certificate.relative_residual, solution.residual);
  if (surfaces.smallest_curvature_positive)
    result.certificate.smallest_curvature_positive = surfaces.smallest_curvature_positive;
  for (const std::string& note : surfaces.notes) result.certificate.notes.push_back(note);
  result.energy.binding = solution.binding_energy;
  result.energy.bending = solution.bending_energy;
  result.energy.stretching = solution.stretching_energy;
  result.energy.joining = solution.joining_energy;
  result.energy.contact = solution.contact_energy;
  result.iterations["surface"] = solution.iterations;
  result.ends.insert(result.ends.end(), surfaces.ends.begin(), surfaces.ends.end());
}

// support + load + join + contact + pressure = 0 up to `residual`.
Balance wall_balance(const Prediction& prediction, size_t v) {
  const BodySolution& body = prediction.surfaces->solution.bodies[v];
  Balance balance;
  balance.vessel = prediction.vessels[v].prepared.spec.name;
  balance.load = prediction.surfaces->load[v];
  balance.support = body.support - balance.load;
  balance.join = body.joining;
  balance.contact = body.contact;
  if (prediction.vessels[v].prepared.spec.pressure) balance.pressure = body.lumen;
  balance.residual = body.residual;
  return balance;
}

// support + load + join + contact + pressure + binding = 0 up to `residual`. The rod is solved
// first and does not feel the reaction of the surface; the balance states this reaction as
// `rod_unbalanced`.
Balance balance_of(const Prediction& prediction, size_t v) {
  const PredictedVessel& vessel = prediction.vessels[v];
  Balance balance;
  balance.vessel = vessel.prepared.spec.name;
  double largest = 0;
  const int mouth = mouth_of(prediction, vessel);
  Vec3 rod_gap = Vec3::Zero();
  if (vessel.prepared.spec.pressure) balance.pressure = Vec3::Zero();
  for (const RodReaction& reaction : vessel.rod.reactions) {
    const Vec3 force = force_on_wall(vessel, reaction);
    // The join keeps the vein's mouth in its pose, not a support.
    (reaction.node == mouth ? balance.join : balance.support) += force;
    if (balance.pressure) *balance.pressure -= carried_lid(vessel, reaction.node);
    rod_gap += reaction.force;
    largest = std::max(largest, force.norm());
  }
  for (const RodLoad& load : vessel.conditions.rod.loads) {
    balance.load += load.force;
    largest = std::max(largest, load.force.norm());
  }
  rod_gap += balance.load;
  const double rod_residual = largest > 0 ? rod_gap.norm() / largest : 0;
  if (!prediction.surfaces) {
    balance.residual = rod_residual;
    return balance;
  }
  const BodySolution& body = prediction.surfaces->solution.bodies[v];
  balance.support += body.support;
  balance.join += body.joining;
  balance.contact = body.contact;
  balance.binding = body.binding;
  balance.rod_unbalanced = -body.binding;
  balance.residual = std::max(rod_residual, body.residual);
  return balance;
}

// Gaps of the seam in the solved surfaces. False: there are no surfaces, nothing was joined.
bool measure_seam(const Operation& operation, const Points& first, const Points& second,
                  SeamReport& report) {
  report.pairs = static_cast<int>(operation.pairs.size());
  if (first.rows() == 0 || second.rows() == 0) {
    report.largest_gap = report.rms_gap = std::numeric_limits<double>::quiet_NaN();
    return false;
  }
  double sum = 0;
  for (const auto& [a, b] : operation.pairs) {
    const double gap = (first.row(a) - second.row(b)).norm();
    report.largest_gap = std::max(report.largest_gap, gap);
    sum += gap * gap;
  }
  report.rms_gap = std::sqrt(sum / static_cast<double>(operation.pairs.size()));
  return true;
}

// The mouth as one of the vessel of that number.
MouthReport mouth_of(const Prediction& prediction, size_t number) {
  const Operation& operation = *prediction.operation;
  const OperatedVessel& joined = operation.vessels[number];
  const PredictedVessel& vessel = prediction.vessels[vessel_named(prediction, joined.name)];
  const PredictedVessel& other =
      prediction.vessels[vessel_named(prediction, operation.vessels[1 - number].name)];
  std::vector<std::array<int, 2>> pairs = operation.pairs;
  if (number == 1)
    for (auto& pair : pairs) std::swap(pair[0], pair[1]);
  const Vec3 axis = vessel.prepared.vessel.rod.rest[index(joined.rim_node)].director(3);
  return measure_mouth(vessel.prepared, vessel.positions, other.positions, pairs, axis);
}

// The operation with what belongs to the solution: gaps, opened area and mouth.
void add_operation(const Prediction& prediction, Result& result) {
  if (!prediction.operation) return;
  const Operation& operation = *prediction.operation;
  result.glenn = operation.glenn;
  result.end_to_end = operation.end_to_end;
  const auto positions = [&](size_t number) -> const Points& {
    return prediction.vessels[vessel_named(prediction, operation.vessels[number].name)].positions;
  };
  SeamReport& seam = result.glenn ? result.glenn->join : result.end_to_end->join;
  const bool sewn = measure_seam(operation, positions(0), positions(1), seam);
  if (result.glenn) {
    std::vector<int> rim;
    for (const auto& pair : operation.pairs) rim.push_back(pair[1]);
    result.glenn->incision.opened_area =
        sewn ? area_vector(positions(1), rim).norm() : std::numeric_limits<double>::quiet_NaN();
    if (sewn) result.glenn->mouth = mouth_of(prediction, 0);
    warn_of_keep(*result.glenn, result.validity);
  } else {
    if (sewn) result.end_to_end->mouth = mouth_of(prediction, index(result.end_to_end->narrower));
    warn_of_keep(*result.end_to_end, result.validity);
  }
}

void add_contact(const Prediction& prediction, Result& result) {
  for (const ContactSolution& pair : prediction.surfaces->solution.contacts) {
    if (!pair.within_reach) continue;
    const auto name = [&](int body) {
      return prediction.vessels[static_cast<size_t>(body)].prepared.spec.name;
    };
    if (pair.held_depth > 0)
      result.certificate.notes.push_back(
          "contact of " + name(pair.a) + " and " + name(pair.b) + ": their rigid ends are held " +
          number_text(pair.held_depth) +
          " inside each other, where no wall can yield; contact beside them is left out");
    if (pair.swallowed > 0)
      result.certificate.notes.push_back(
          "contact of " + name(pair.a) + " and " + name(pair.b) + ": " +
          (pair.swallowed == 1 ? "1 point was" : std::to_string(pair.swallowed) + " points were") +
          " carried past the other vessel's middle; pressure is left out there");
    result.contact.push_back({name(pair.a), name(pair.b), pair.force, pair.area,
                              pair.largest_pressure, pair.smallest_gap});
  }
}

void describe_model(const Prediction& prediction, Result& result) {
  ModelReport& model = result.model;
  model.left_out = prediction.left_out;
  std::set<std::string> terms;
  const bool start_only = prediction.surfaces && prediction.surfaces->carry_everything;
  bool has_surfaces = false;
  for (const PredictedVessel& vessel : prediction.vessels) {
    if (vessel.stump) continue;
    model.rod_nodes += vessel.prepared.vessel.rod.node_count();
    model.vertices += static_cast<int>(vessel.positions.rows());
    if (vessel.positions.rows() > 0)
      model.triangles += static_cast<int>(vessel.prepared.vessel.surface.triangles.rows());
    model.cleaning[vessel.prepared.spec.name] = vessel.prepared.loaded.report.text();
    if (vessel.rod_solved && !start_only) {
      terms.insert("rod");
      if (vessel.prepared.spec.pressure) terms.insert("pressure");
    }
    has_surfaces |= vessel.positions.rows() > 0;
  }
  if (prediction.surfaces)
    terms.insert(prediction.surfaces->terms.begin(), prediction.surfaces->terms.end());
  if (prediction.operation && has_surfaces) terms.insert("joining");
  if (!result.contact.empty()) terms.insert("contact");
  model.terms.assign(terms.begin(), terms.end());
}

}  // namespace

Result result_of(const Prediction& prediction, int threads) {
  Result result =
      begin_result(prediction.scene->name, prediction.fidelity, prediction.scene->units, threads);
  result.status = prediction.status;
  add_rods(prediction, result);
  if (prediction.surfaces) {
    add_surfaces(*prediction.surfaces, result);
    add_contact(prediction, result);
  }
  const bool walls = prediction.surfaces && prediction.surfaces->carry_everything;
  for (size_t v = 0; v < prediction.vessels.size(); ++v)
    if (!prediction.vessels[v].prepared.obstacle())
      result.balance.push_back(walls ? wall_balance(prediction, v) : balance_of(prediction, v));
  add_operation(prediction, result);
  describe_model(prediction, result);
  add_vessels(prediction, result);
  if (const auto joined = joined_vessels(result); joined && joined->mouth != nullptr) {
    const std::size_t before = result.validity.warnings.size();
    for (VesselMetrics& metrics : result.metrics)
      if (metrics.vessel == joined->mouth_of)
        judge_mouth(metrics.vessel, *joined->mouth, metrics, result.validity);
    // The mouth of a state that is no solution gives no warning.
    if (!is_solution(result.status)) result.validity.warnings.resize(before);
  }
  for (const std::string& note : prediction.notes) result.certificate.notes.push_back(note);
  return result;
}

}  // namespace vasorod
