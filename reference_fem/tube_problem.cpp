#include "reference_fem/tube_problem.h"

#include <Eigen/Geometry>
#include <cmath>
#include <memory>
#include <numbers>

#include <vasorod/error.h>

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
  if (scene.glenn) refuse(scene, "a surgery", can);
  if (scene.vessels.size() != 1)
    refuse(scene, std::to_string(scene.vessels.size()) + " vessels", can);
  const VesselSpec& vessel = scene.vessels.front();
  if (vessel.role == Role::obstacle) refuse(scene, "the obstacle " + quoted(vessel.name), can);
  if (vessel.rod) refuse(scene, "the bare rod " + quoted(vessel.name), can);
  if (!vessel.tube) refuse(scene, "the surface of " + quoted(vessel.name), can);
  return vessel;
}

Pose placement(const TubeSpec& tube, double unit) {
  Pose pose;
  const Vec3 d3 = tube.tangent.normalized();
  const Vec3 d1 = (tube.normal - tube.normal.dot(d3) * d3).normalized();
  pose.rotation << d1, d3.cross(d1), d3;
  pose.position = tube.position / unit;
  return pose;
}

int side_of(const TubeShape& shape, const EndSelector& end, double unit) {
  if (end.kind == EndSelector::Kind::start) return 0;
  if (end.kind == EndSelector::Kind::end) return 1;
  const Vec3 at = end.near / unit;
  return (shape.section(0).position - at).norm() <= (shape.section(1).position - at).norm() ? 0 : 1;
}

// The reference has its own moduli and laws, independent of the hybrid solver's.
Moduli moduli_of(const Material& m, double unit) {
  if (m.is_isotropic()) return Moduli::isotropic(m.young_axial / unit, m.poisson_tt);
  return {m.young_axial / unit, m.young_transverse / unit, m.poisson_tt,
          m.poisson_lt,         m.shear_axial / unit,      false};
}

std::vector<EndProblem> ends_of(const Scene& scene, const TubeProblem& problem) {
  std::vector<EndProblem> ends;
  for (const EndCondition& condition : scene.ends) {
    const int side = side_of(problem.shape, condition.end, problem.length_unit);
    EndProblem* entry = nullptr;
    for (EndProblem& known : ends)
      if (known.side == side) entry = &known;
    if (entry == nullptr) {
      ends.emplace_back();
      entry = &ends.back();
      entry->name = to_string(condition.end);
      entry->side = side;
    }
    entry->soft = entry->soft || condition.soft_section;
    if (condition.hold || condition.rotate_deg || condition.move) entry->fixed.fill(true);
    for (std::size_t k = 0; k < 6; ++k) entry->fixed[k] = entry->fixed[k] || condition.fix[k];
    if (condition.rotate_deg) entry->rotation = *condition.rotate_deg * (std::numbers::pi / 180);
    if (condition.move) entry->move = *condition.move / problem.length_unit;
    if (condition.force) entry->force = *condition.force / problem.force_unit();
    if (condition.moment) entry->moment = *condition.moment / problem.moment_unit();
    entry->moment_in_body = entry->moment_in_body || condition.moment_in_body;
  }
  int fixed = 0;
  for (const EndProblem& end : ends)
    for (const bool f : end.fixed) fixed += f ? 1 : 0;
  if (fixed < 6)
    throw InputError(scene.file.string() + ": ends: found " + std::to_string(fixed) +
                     " components held in all, expected at least 6, as the tube would float away");
  return ends;
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

std::unique_ptr<Model> build(const TubeProblem& problem, ModelKind kind, const TubeMesh& size,
                             const Processes& processes, std::vector<Section>& sections,
                             const Mesh*& mesh) {
  const TubeShape& shape = problem.shape;
  const MaterialLaw law(problem.law, problem.moduli);
  const auto finish = [&](auto model) -> std::unique_ptr<Model> {
    for (const EndProblem& end : problem.ends) {
      Section section = end_section(*model, shape, end.side, end.soft);
      section.fixed = end.fixed;
      section.move = end.move;
      section.rotation = end.rotation;
      section.force = end.force;
      section.moment = end.moment;
      section.moment_in_body = end.moment_in_body;
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
    if (problem.pressure != 0) solid->add_pressure(2, 0, problem.pressure);
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
  if (problem.pressure != 0) shell->add_pressure(problem.pressure);
  return finish(std::move(shell));
}

LawKind law_of(const Material& material) {
  switch (material.law) {
    case Law::biot:
      return LawKind::biot;
    case Law::svk:
      return LawKind::svk;
    case Law::neo_hookean:
      return LawKind::neo_hookean;
  }
  return LawKind::biot;
}

}  // namespace

TubeProblem read_problem(const Scene& scene, ModelKind kind, std::optional<LawKind> law) {
  const VesselSpec& vessel = only_tube(scene);
  const TubeSpec& tube = *vessel.tube;
  TubeProblem problem;
  problem.vessel = vessel.name;
  problem.length_unit = tube.radius;
  problem.stress_unit = vessel.wall->material.young_axial;
  problem.moduli = moduli_of(vessel.wall->material, problem.stress_unit);
  problem.law = law.value_or(law_of(vessel.wall->material));
  try {
    const MaterialLaw check(problem.law, problem.moduli);
  } catch (const InputError& error) {
    throw InputError(scene.file.string() + ": " + vessel.name + ": " + error.what());
  }
  const double unit = problem.length_unit;
  problem.shape.length = tube.length / unit;
  problem.shape.radius = 1;
  problem.shape.thickness = vessel.wall->thickness / unit;
  problem.shape.end_radius = tube.end_radius.value_or(tube.radius) / unit;
  problem.shape.end_thickness = tube.end_thickness.value_or(vessel.wall->thickness) / unit;
  problem.shape.bend = tube.bend_deg * std::numbers::pi / 180;
  problem.shape.placement = placement(tube, unit);
  problem.ends = ends_of(scene, problem);
  if (kind == ModelKind::shell && problem.law == LawKind::split_neo_hookean)
    refuse(scene, "the law split-neo-hookean with `--model shell`", "it with `--model solid` only");
  if (vessel.pressure) problem.pressure = *vessel.pressure / problem.stress_unit;
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
  const System system(*model, std::move(supports), processes);
  solution.unknowns = system.size();
  const auto abscissa = [&](double s) { return size.file.empty() ? graded_inverse(s) : s; };
  std::vector<Vec3> at;
  for (int j = 0; j < stations; ++j)
    for (int i = 0; i < points_around; ++i)
      at.emplace_back(static_cast<double>(i) / points_around,
                      abscissa(static_cast<double>(j) / (stations - 1)), 0.5);
  const std::vector<CellRow> rows = mesh->rows_at(at);
  solution.mesh_seconds = now() - start;

  State state;
  System::Assembly assembly;
  solution.summary = follow_path(system, state, assembly, options);
  solution.end_force = assembly.section_force;
  solution.end_pose = state.pose;
  solution.wall.around = points_around;
  solution.wall.along = stations;
  solution.wall.rest.resize(static_cast<Eigen::Index>(rows.size()), 3);
  solution.wall.current = solution.wall.rest;
  for (std::size_t r = 0; r < rows.size(); ++r) {
    Vec3 X = Vec3::Zero(), u = Vec3::Zero();
    const std::vector<int>& nodes = mesh->cell_nodes[static_cast<std::size_t>(rows[r].cell)];
    for (std::size_t a = 0; a < nodes.size(); ++a) {
      const double N = rows[r].shape[static_cast<Eigen::Index>(a)];
      X += N * mesh->nodes.row(nodes[a]).transpose();
      u += N * state.u.segment<3>(static_cast<Eigen::Index>(model->components()) * nodes[a]);
    }
    solution.wall.rest.row(static_cast<Eigen::Index>(r)) = X;
    solution.wall.current.row(static_cast<Eigen::Index>(r)) = X + u;
  }
  return solution;
}

}  // namespace vasorod::fem
