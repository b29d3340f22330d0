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

}  // namespace

PaperProblem surface_problem(const Prediction& prediction) {
  const auto body_named = [&](const std::string& name) {
    return static_cast<int>(vessel_named(prediction, name));
  };
  PaperProblem problem;
  for (const PredictedVessel& vessel : prediction.vessels) problem.bodies.push_back(body_of(vessel));
  if (prediction.glenn) {
    const int svc = body_named(prediction.glenn->report.svc), rpa = body_named(prediction.glenn->report.rpa);
    for (const auto& [a, b] : prediction.glenn->pairs) problem.seams.push_back({svc, a, rpa, b});
  }
  if (prediction.scene->contact)
    for (const auto& [a, b] : *prediction.scene->contact)
      problem.contacts.emplace_back(body_named(a), body_named(b));
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
  take_surfaces(solve_paper(*prediction.problem, paper), "surface", prediction);
}

void take_surfaces(PaperSolution&& solution, const std::string& what, Prediction& prediction) {
  prediction.surface = std::move(solution);
  for (size_t v = 0; v < prediction.vessels.size(); ++v) {
    PredictedVessel& vessel = prediction.vessels[v];
    const BodySolution& body = prediction.surface->bodies[v];
    vessel.positions = body.positions;
    vessel.pressure = body.pressure;
    if (!body.modelled && !vessel.prepared.obstacle())
      prediction.left_out[what + " of " + vessel.prepared.spec.name] =
          "nothing moves, joins or touches it: it stays as it is";
  }
  const auto& contacts = prediction.surface->contacts;
  if (std::none_of(contacts.begin(), contacts.end(),
                   [](const ContactSolution& pair) { return pair.within_reach; }))
    prediction.left_out["contact"] = "no vessel within reach";
}

}  // namespace vasorod
