#include "app/solve_surfaces.h"

#include <algorithm>

#include "geometry/triangle_surface.h"
#include "surface/joined_skin.h"
#include "surface/paper_solver.h"

namespace vasorod {
namespace {

PaperCoefficients coefficients_of(const PreparedVessel& vessel) {
  if (vessel.spec.coefficients)
    return {vessel.spec.coefficients->binding, vessel.spec.coefficients->bending,
            vessel.spec.coefficients->stretching};
  WallAndMesh wall;
  wall.young = vessel.spec.wall->young;
  wall.poisson = vessel.spec.wall->poisson;
  wall.thickness = vessel.spec.wall->thickness;
  wall.radius = vessel.vessel.mean_radius;
  wall.mean_edge = mean_edge_length(vessel.vessel.surface);
  wall.vertex_area =
      total_area(vessel.vessel.surface) / static_cast<double>(vessel.vessel.surface.points.rows());
  return coefficients_from_wall(wall);
}

SurfaceBody body_of(const PredictedVessel& vessel) {
  const PreparedVessel& prepared = vessel.prepared;
  SurfaceBody body;
  body.name = prepared.spec.name;
  body.rest = prepared.vessel.surface;
  body.thickness = prepared.thickness();
  body.offset = prepared.outer_offset();
  body.obstacle = prepared.obstacle();
  if (body.obstacle) return body;
  body.k = coefficients_of(prepared);
  body.fixed.assign(static_cast<size_t>(body.rest.points.rows()), 0);
  for (const ConditionedEnd& end : vessel.conditions.ends) {
    if (!end.rigid) continue;
    for (const int vertex : prepared.vessel.ends[static_cast<size_t>(end.end)].loop)
      body.fixed[static_cast<size_t>(vertex)] = 1;
  }
  if (vessel.rod_solved) {
    body.carried = carried_points(prepared.vessel.rod, vessel.rod.poses, prepared.vessel.binding);
    body.rotations = carried_rotations(prepared.vessel.rod, vessel.rod.poses, prepared.vessel.binding);
  }
  return body;
}

int vessel_named(const Prediction& prediction, const std::string& name) {
  for (size_t v = 0; v < prediction.vessels.size(); ++v)
    if (prediction.vessels[v].prepared.spec.name == name) return static_cast<int>(v);
  return -1;
}

}  // namespace

PaperProblem surface_problem(const Prediction& prediction) {
  PaperProblem problem;
  for (const PredictedVessel& vessel : prediction.vessels) problem.bodies.push_back(body_of(vessel));
  if (prediction.glenn) {
    const int svc = vessel_named(prediction, prediction.glenn->report.svc);
    const int rpa = vessel_named(prediction, prediction.glenn->report.rpa);
    for (const auto& [a, b] : prediction.glenn->pairs) problem.seams.push_back({svc, a, rpa, b});
  }
  if (prediction.scene->contact)
    for (const auto& [a, b] : *prediction.scene->contact)
      problem.contacts.emplace_back(vessel_named(prediction, a), vessel_named(prediction, b));
  else
    problem.contacts = all_contacts(problem.bodies);
  return problem;
}

void solve_skin(Prediction& prediction) {
  prediction.problem = surface_problem(prediction);
  const auto positions = joined_skin(*prediction.problem);
  for (size_t v = 0; v < positions.size(); ++v) prediction.vessels[v].positions = positions[v];
  prediction.left_out["contact"] =
      "fidelity skin: sections are carried rigidly, nothing can yield to a pressure";
}

void solve_paper_surfaces(Prediction& prediction, const SolveOptions& options) {
  prediction.problem = surface_problem(prediction);
  PaperOptions paper;
  paper.certify = options.certify;
  paper.keep_going = [&](const PaperProgress& at) {
    if (at.iterations % 50 == 0)
      options.progress("surfaces: update " + std::to_string(at.outer) + ", iteration " +
                       std::to_string(at.iterations));
    return !options.stop();
  };
  prediction.surface = solve_paper(*prediction.problem, paper);
  for (size_t v = 0; v < prediction.vessels.size(); ++v) {
    prediction.vessels[v].positions = prediction.surface->bodies[v].positions;
    prediction.vessels[v].pressure = prediction.surface->bodies[v].pressure;
    if (!prediction.surface->bodies[v].modelled && !prediction.vessels[v].prepared.obstacle())
      prediction.left_out["surface of " + prediction.vessels[v].prepared.spec.name] =
          "nothing moves, joins or touches it: it stays as it is";
  }
  bool touching = false;
  for (const ContactSolution& pair : prediction.surface->contacts) touching |= pair.within_reach;
  if (!touching) prediction.left_out["contact"] = "no vessel within reach";
}

}  // namespace vasorod
