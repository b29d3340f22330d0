#include <algorithm>

#include "coupled/coupled_problem.h"
#include "data/index.h"
#include "paper/joined_skin.h"
#include "predict/fidelities/fidelities.h"
#include "predict/kept_state.h"
#include "predict/path_rule.h"
#include "predict/surface_bodies.h"
#include "predict/vessel_wall.h"
#include "predict/walls_means.h"
#include "rod/binding.h"

namespace vasorod {
namespace {

CarriedBody carried_by(const PredictedVessel& vessel, const RodPoses& poses,
                       const VesselSections& sections) {
  const Vessel& v = vessel.prepared.vessel;
  CarriedBody body;
  body.points = carried_points(v.rod, poses, v.carry);
  body.rotations = carried_rotations(v.rod, poses, v.carry);
  for (const int node : sections.nodes)
    body.sections.push_back(
        {poses[index(node)].rotation * v.rod.rest[index(node)].rotation.transpose(),
         poses[index(node)].position});
  return body;
}

CoupledProblem problem_of(Prediction& prediction, std::vector<VesselSections>& sections) {
  CoupledProblem problem;
  problem.surfaces = body_problem(prediction);
  // Beside a seam the walls meet as they are sewn, and its start may lie through itself.
  if (!prediction.operation)
    for (const auto& itself : self_contacts(problem.surfaces.bodies))
      problem.surfaces.contacts.push_back(itself);
  for (const PredictedVessel& vessel : prediction.vessels) {
    sections.emplace_back();
    problem.vessels.emplace_back();
    if (vessel.prepared.obstacle()) continue;
    sections.back() =
        sections_of(vessel.prepared.vessel, vessel.conditions, mouth_of(prediction, vessel));
    problem.vessels.back() = std::make_unique<CoupledVessel>(CoupledVessel{
        wall_of(vessel.prepared), sections.back().sections, vessel.prepared.spec.pressure});
  }
  // A seam starts closed: a linear solve of the paper's quadratic energies deforms the carried
  // sections as little as possible.
  std::vector<Points> joined;
  if (prediction.operation) joined = joined_skin(problem.surfaces, &prediction.work);
  problem.carried = [&prediction, &sections, joined](double t) {
    std::vector<CarriedBody> bodies;
    for (size_t v = 0; v < prediction.vessels.size(); ++v) {
      const PredictedVessel& vessel = prediction.vessels[v];
      bodies.emplace_back();
      if (!vessel.rod_solved) {
        if (!joined.empty() && !vessel.prepared.obstacle()) bodies.back().points = joined[v];
        continue;
      }
      const RodPoses poses = t == 1
                                 ? vessel.rod.poses
                                 : share_of_strain(vessel.prepared.vessel.rod, vessel.rod.poses, t);
      bodies.back() = carried_by(vessel, poses, sections[v]);
      if (!joined.empty()) bodies.back().points = joined[v];
    }
    return bodies;
  };
  return problem;
}

void take(CoupledSolution&& solution, const std::vector<VesselSections>& sections,
          Prediction& prediction) {
  SolvedSurfaces surfaces;
  surfaces.solution = std::move(solution.surface);
  surfaces.solution.status = solution.status;
  surfaces.smallest_curvature_positive = solution.smallest_curvature_positive;
  surfaces.notes = solution.notes;
  surfaces.terms = {"bending", "stretching"};
  for (const PredictedVessel& vessel : prediction.vessels)
    if (vessel.prepared.spec.pressure) surfaces.terms.emplace_back("pressure");
  surfaces.carry_everything = true;
  surfaces.faces = solution.faces;
  for (size_t v = 0; v < prediction.vessels.size(); ++v) {
    Vec3& load = surfaces.load.emplace_back(Vec3::Zero());
    for (const SectionSolution& section : solution.sections[v]) {
      load += section.load;
      if (!section.label.empty())
        surfaces.ends.push_back({prediction.vessels[v].prepared.spec.name, section.label,
                                 section.force, section.moment, section.center});
    }
  }
  take_surfaces(std::move(surfaces), "wall", prediction);
  prediction.left_out["energy of the rods"] =
      "fidelity coupled: the walls carry all of it; the rods are start, frames and report";
  give_rods_the_walls_means(prediction, sections, solution.sections);
}

}  // namespace

void solve_coupled(Prediction& prediction, const SolveOptions& options) {
  std::vector<VesselSections> sections;
  CoupledOptions coupled;
  coupled.times = path_times(prediction);
  coupled.stop = options.stop;
  coupled.step = step_progress("walls", options);
  coupled.progress = iteration_progress("walls", 10, options);
  coupled.keep = keep_for<CoupledSolution>(prediction, options,
                                           [&](CoupledSolution&& so_far, Prediction& state) {
                                             take(std::move(so_far), sections, state);
                                           });
  CoupledSolver solver(problem_of(prediction, sections), coupled);
  take(solver.solve(), sections, prediction);
}

}  // namespace vasorod
