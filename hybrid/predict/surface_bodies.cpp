#include "predict/surface_bodies.h"

#include <algorithm>

#include "bodies/spring_coefficients.h"
#include "geometry/triangle_surface.h"
#include "predict/stump.h"

namespace vasorod {
namespace {

Coefficients coefficients_of(const PreparedVessel& vessel) {
  if (vessel.spec.coefficients) return *vessel.spec.coefficients;
  const TriangleSurface& surface = vessel.vessel.surface;
  const WallGeometry wall{
      .thickness = vessel.thickness(),
      .radius = vessel.vessel.mean_radius,
      .mean_edge = mean_edge_length(surface),
      .vertex_area = total_area(surface) / static_cast<double>(surface.points.rows())};
  return coefficients_from_wall(vessel.spec.wall->material, wall);
}

SurfaceBody body_of(const PredictedVessel& vessel) {
  const PreparedVessel& prepared = vessel.prepared;
  SurfaceBody body;
  body.name = prepared.spec.name;
  body.rest = prepared.vessel.surface;
  body.thickness = prepared.thickness();
  body.offset = prepared.outer_offset();
  body.obstacle = prepared.obstacle();
  body.edged = vessel.stump;
  if (body.obstacle) return body;
  body.k = coefficients_of(prepared);
  body.fixed.assign(static_cast<size_t>(body.rest.points.rows()), 0);
  for (const ConditionedEnd& end : vessel.conditions.ends) {
    if (!end.rigid) continue;
    for (const int vertex : prepared.vessel.ends[static_cast<size_t>(end.end)].loop)
      body.fixed[static_cast<size_t>(vertex)] = 1;
  }
  if (vessel.rod_solved) {
    body.carried = carried_points(prepared.vessel.rod, vessel.rod.poses, prepared.vessel.carry);
    body.rotations =
        carried_rotations(prepared.vessel.rod, vessel.rod.poses, prepared.vessel.carry);
  }
  return body;
}

}  // namespace

BodyProblem body_problem(const Prediction& prediction) {
  const auto body_named = [&](const std::string& name) {
    return static_cast<int>(vessel_named(prediction, name));
  };
  BodyProblem problem;
  for (const PredictedVessel& vessel : prediction.vessels)
    problem.bodies.push_back(body_of(vessel));
  if (prediction.operation) {
    const auto& joined = prediction.operation->vessels;
    const int first = body_named(joined[0].name), second = body_named(joined[1].name);
    for (const auto& [a, b] : prediction.operation->pairs)
      problem.seams.push_back({first, a, second, b});
  }
  if (!prediction.scene->contact) {
    problem.contacts = all_contacts(problem.bodies);
    return problem;
  }
  for (const auto& [a, b] : *prediction.scene->contact)
    problem.contacts.emplace_back(body_named(a), body_named(b));
  touch_stump(prediction, problem);
  return problem;
}

void take_surfaces(SolvedSurfaces&& surfaces, const std::string& what, Prediction& prediction) {
  prediction.surfaces = std::move(surfaces);
  prediction.crossings.reset();
  prediction.work += prediction.surfaces->solution.work;
  for (size_t v = 0; v < prediction.vessels.size(); ++v) {
    PredictedVessel& vessel = prediction.vessels[v];
    const BodySolution& body = prediction.surfaces->solution.bodies[v];
    vessel.positions = body.positions;
    vessel.pressure = body.pressure;
    if (!body.modelled && !vessel.prepared.obstacle())
      prediction.left_out[what + " of " + vessel.prepared.spec.name] =
          "nothing moves, joins or touches it: it stays as it is";
  }
  const auto& contacts = prediction.surfaces->solution.contacts;
  if (std::none_of(contacts.begin(), contacts.end(),
                   [](const ContactSolution& pair) { return pair.within_reach; }))
    prediction.left_out["contact"] = "no vessel within reach";
}

std::function<void(const SolverProgress&)> iteration_progress(const std::string& what, int every,
                                                              const SolveOptions& options) {
  if (!options.progress) return {};
  return [what, every, tell = options.progress](const SolverProgress& at) {
    if (at.iterations % every == 0)
      tell(what + ": update " + std::to_string(at.outer) + ", iteration " +
           std::to_string(at.iterations));
  };
}

std::function<void(const std::string&)> step_progress(const std::string& what,
                                                      const SolveOptions& options) {
  if (!options.progress) return {};
  return [what, tell = options.progress](const std::string& step) { tell(what + ": " + step); };
}

}  // namespace vasorod
