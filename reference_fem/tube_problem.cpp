#include "reference_fem/tube_problem.h"

#include <Eigen/Geometry>
#include <cmath>
#include <memory>
#include <numbers>

#include <vasorod/error.h>

#include "numerics/stress_free_search.h"
#include "reference_fem/clock.h"
#include "reference_fem/mesh_file.h"

namespace vasorod::fem {
namespace {

std::string quoted(const std::string& text) {
  return "\"" + text + "\"";
}

[[noreturn]] void refuse(const Scene& scene, const std::string& found,
                         const std::string& expected) {
  throw InputError(scene.file.string() + ": found " + found +
                   "; the finite-element reference solves " + expected);
}

const VesselSpec& only_tube(const Scene& scene) {
  const std::string can = "one generated tube (`tube:`) with conditions at its ends";
  if (scene.vessels.size() != 1)
    refuse(scene, std::to_string(scene.vessels.size()) + " vessels", can);
  const VesselSpec& vessel = scene.vessels.front();
  if (vessel.role == Role::obstacle) refuse(scene, "the obstacle " + quoted(vessel.name), can);
  if (vessel.rod) refuse(scene, "the bare rod " + quoted(vessel.name), can);
  if (!vessel.tube) refuse(scene, "the surface of " + quoted(vessel.name), can);
  return vessel;
}

/// Abscissa of a mesh parameter. Cells shrink towards the ends, where rigid sections cause edge
/// layers of width about sqrt(R t).
double graded(double p) {
  return p - 0.4 * std::sin(2 * std::numbers::pi * p) / (2 * std::numbers::pi);
}
Vec3 graded(const Vec3& p) {
  return {p[0], graded(p[1]), p[2]};
}

double graded_inverse(double s) {
  double p = s;
  for (int i = 0; i < 60; ++i)
    p -= (graded(p) - s) / (1 - 0.4 * std::cos(2 * std::numbers::pi * p));
  return p;
}

std::unique_ptr<VesselModel> build(const TubeProblem& problem, ModelKind kind, const TubeMesh& size,
                                   const Processes& processes, std::vector<Section>& sections,
                                   const Mesh*& mesh) {
  const TubeShape& shape = problem.shape;
  const MaterialLaw law(problem.law, problem.moduli);
  const auto finish = [&](auto model) -> std::unique_ptr<VesselModel> {
    for (const EndProblem& end : problem.ends) {
      Section section = end_section(*model, shape, end.side, end.soft);
      apply(end, section);
      sections.push_back(std::move(section));
    }
    mesh = &model->mesh();
    return model;
  };
  const MeshFile file{size.file, problem.length_unit, size.halvings};
  const Block block{{size.around, size.along, 1}, true, size.degree};
  // the abscissae of a file's cells are not graded
  const auto place = [graded_cells = size.file.empty()](const Vec3& p) {
    return graded_cells ? graded(p) : p;
  };
  const Axes axes = [=](const Vec3& p) { return shape.axes(place(p)); };
  if (kind == ModelKind::solid) {
    Mesh cells = size.file.empty()
                     ? make_solid(
                           block, [&](const Vec3& p) { return shape.point(place(p)); }, processes)
                     : read_solid(file, shape, size.degree, processes);
    auto solid = std::make_unique<Solid>(std::move(cells), law, axes);
    if (problem.seen.pressed()) solid->add_pressure(2, 0, problem.seen.pressure.after);
    return finish(std::move(solid));
  }
  const ShellBody body{[=](const Vec3& p) { return Vec3(shape.axes(place(p)).col(0)); },
                       [=](const Vec3& p) { return shape.thickness_at(place(p)[1]); }, axes};
  Mesh cells = size.file.empty() ? make_surface(
                                       block,
                                       [&](const Vec3& p) {
                                         return shape.point(place({p[0], p[1], 0.5}));
                                       },
                                       processes)
                                 : read_surface(file, shape, size.degree, processes);
  auto shell =
      std::make_unique<Shell>(std::move(cells), law, body, problem.law == LawKind::svk ? 2 : 3);
  return finish(std::move(shell));
}

}  // namespace

TubeProblem read_problem(const Scene& scene, ModelKind kind, std::optional<LawKind> law) {
  const VesselSpec& vessel = only_tube(scene);
  TubeProblem problem;
  problem.vessel = vessel.name;
  problem.length_unit = vessel.tube->radius;
  problem.stress_unit = vessel.wall->material.young_axial;
  problem.moduli = moduli_of(vessel.wall->material, problem.stress_unit);
  problem.law = law.value_or(law_of(vessel.wall->material));
  require_admissible(scene, problem.vessel, problem.law, problem.moduli);
  const ProblemUnits units{problem.length_unit, problem.stress_unit};
  problem.shape = shape_of(vessel, units);
  problem.ends = ends_of(scene, problem.vessel, problem.shape, units);
  require_held(scene, problem.ends, "the tube");
  if (kind == ModelKind::shell && problem.law == LawKind::split_neo_hookean)
    refuse(scene, "the law split-neo-hookean with `--model shell`", "it with `--model solid` only");
  problem.seen = seen_state(scene, vessel, units);
  return problem;
}

TubeSolution solve_tube(const TubeProblem& problem, ModelKind kind, const TubeMesh& size,
                        int points_around, int stations, const StepperOptions& options,
                        const Processes& processes) {
  TubeSolution solution;
  const double start = now();
  const Mesh* mesh = nullptr;
  Supports supports;
  const auto model = build(problem, kind, size, processes, supports.sections, mesh);
  if (problem.seen.stressed()) {
    const double radius = problem.shape.mean_radius();
    const SeenDisplacement found =
        seen_displacement(*model, problem.seen, supports, largest_linear_prestrain, processes);
    give_prestress(*model, problem.seen, found, processes);
    solution.seen = {found.largest / radius, found.steps};
  }
  model->set_pressure(problem.seen.pressure);
  System system(*model, std::move(supports), processes);
  if (problem.seen.stressed()) system.start_from(system.rest());
  solution.unknowns = system.size();
  const auto abscissa = [&](double s) { return size.file.empty() ? graded_inverse(s) : s; };
  std::vector<Vec3> at;
  for (int j = 0; j < stations; ++j)
    for (int i = 0; i < points_around; ++i)
      at.emplace_back(static_cast<double>(i) / points_around,
                      abscissa(static_cast<double>(j) / (stations - 1)), 0.5);
  solution.mesh_seconds = now() - start;

  State state;
  System::Assembly assembly;
  solution.summary = follow_path(system, state, assembly, options);
  solution.end_force = assembly.section_force;
  solution.end_pose = state.pose;
  solution.wall.around = points_around;
  solution.wall.along = stations;
  for (int j = 0; j < stations; ++j)
    solution.wall.fraction.push_back(static_cast<double>(j) / (stations - 1));
  WallPoints points = wall_points(*mesh, state.u, model->components(), at);
  solution.wall.rest = std::move(points.rest);
  solution.wall.current = std::move(points.current);
  return solution;
}

}  // namespace vasorod::fem
