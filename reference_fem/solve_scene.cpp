#include "reference_fem/solve_scene.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <vasorod/error.h>

#include "reference_fem/clock.h"
#include "reference_fem/mesh_file.h"
#include "reference_fem/refinement.h"
#include "reference_fem/solve_join_scene.h"
#include "reference_fem/solve_parts.h"
#include "reference_fem/tube_result.h"

namespace vasorod::fem {
namespace {

TubeMesh first_mesh(const TubeProblem& problem, const SolveOptions& options) {
  check_options(options);
  if (!options.mesh.empty()) {
    const MeshFile file{options.mesh, problem.length_unit, 0};
    const Mesh cells = options.model == ModelKind::solid ? read_solid(file, problem.shape, 1)
                                                         : read_surface(file, problem.shape, 1);
    const CellCount count = count_cells(cells);
    return {count.around, count.along, options.degree, options.mesh, 0};
  }
  const int multiple = 1 << options.refine;  // so that every refinement by 3/2 gives integers
  const int around = options.around == 0 ? 8 : options.around;
  if (around < 4 || around % multiple != 0 || options.along < 0 || options.along % multiple != 0)
    throw InputError("--cells: found " + std::to_string(around) + " x " +
                     std::to_string(options.along) +
                     ", expected at least 4 around, and multiples of " + std::to_string(multiple) +
                     " for --refine " + std::to_string(options.refine));
  TubeMesh mesh{around, options.along, options.degree, {}, 0};
  if (mesh.along == 0) {
    const double wanted = problem.shape.length / (2 * std::numbers::pi / mesh.around);
    mesh.along = 4 * std::max(1, static_cast<int>(std::lround(wanted / 4)));
  }
  return mesh;
}

/// Ratio to the next finer mesh: 3/2 for structured cells, 2 for a file's.
double refinement_ratio(const SolveOptions& options) {
  return options.mesh.empty() ? 1.5 : 2;
}

TubeMesh refined(TubeMesh mesh, const SolveOptions& options) {
  mesh.around = static_cast<int>(std::lround(refinement_ratio(options) * mesh.around));
  mesh.along = static_cast<int>(std::lround(refinement_ratio(options) * mesh.along));
  if (!options.mesh.empty()) ++mesh.halvings;
  return mesh;
}

struct Level {
  TubeMesh mesh;
  TubeSolution solution;
};

/// Changes between two meshes: displacements (root mean square over the radius), reactions and
/// energy (relative).
struct Change {
  double displacement = 0, reaction = 0, energy = 0;
};

Change change(const TubeSolution& a, const TubeSolution& b) {
  Change out;
  const Points difference = (a.wall.current - a.wall.rest) - (b.wall.current - b.wall.rest);
  out.displacement = std::sqrt(difference.squaredNorm() / static_cast<double>(difference.rows()));
  // dimensionless lengths are in radii, so forces and moments are comparable
  double size = 0;
  for (std::size_t e = 0; e < a.end_force.size(); ++e) {
    out.reaction = std::max(out.reaction, (a.end_force[e] - b.end_force[e]).cwiseAbs().maxCoeff());
    size = std::max(size, a.end_force[e].cwiseAbs().maxCoeff());
  }
  if (size > 0) out.reaction /= size;
  if (a.summary.energy != 0)
    out.energy = std::abs(a.summary.energy - b.summary.energy) / std::abs(a.summary.energy);
  return out;
}

void estimate_error(const std::vector<Level>& levels, int degree, double ratio, Result& result) {
  result.discretisation.emplace();
  result.discretisation->dofs = levels.back().solution.unknowns;
  result.discretisation->degree = degree;
  if (levels.size() < 2) return;
  const std::size_t n = levels.size();
  const Change fine = change(levels[n - 1].solution, levels[n - 2].solution);
  std::optional<Change> coarse;
  if (n > 2) coarse = change(levels[n - 2].solution, levels[n - 3].solution);
  const auto index = [&](double Change::*member, double theory) {
    return grid_convergence(fine.*member,
                            coarse ? std::optional<double>((*coarse).*member) : std::nullopt, ratio,
                            theory);
  };
  // energies and reactions converge in the square of the energy norm, displacements in L2
  const Convergence displacement = index(&Change::displacement, degree + 1),
                    reaction = index(&Change::reaction, 2 * degree),
                    energy = index(&Change::energy, 2 * degree);
  result.discretisation->error_estimate =
      std::max({displacement.uncertainty, reaction.uncertainty, energy.uncertainty});
  result.discretisation->observed_order = energy.observed_order;
  const auto note = [&](const char* what, const Convergence& convergence) {
    result.certificate.notes.push_back(error_note(what, convergence, ratio));
  };
  note("displacements over R (RMS)", displacement);
  note("reactions, relative", reaction);
  note("energy, relative", energy);
}

void report_ends(const TubeProblem& problem, const TubeSolution& solution, Result& result) {
  Balance balance;
  balance.vessel = problem.vessel;
  double largest = 0;
  for (std::size_t e = 0; e < problem.ends.size(); ++e) {
    const EndProblem& end = problem.ends[e];
    const double load = solution.summary.load;
    const Vec3 force = load * end.force;
    Vec3 moment = load * end.moment;
    if (end.moment_in_body) moment = solution.end_pose[e].rotation * moment;
    EndReaction reaction;
    reaction.vessel = problem.vessel;
    reaction.end = end.name;
    reaction.force = problem.force_unit() * (solution.end_force[e].head<3>() - force);
    reaction.moment = problem.moment_unit() * (solution.end_force[e].tail<3>() - moment);
    reaction.center = problem.length_unit * solution.end_pose[e].position;
    balance.support += reaction.force;
    balance.load += problem.force_unit() * force;
    // A tube under moments alone has forces of round-off only. Moments over the radius set the
    // scale.
    largest = std::max({largest, reaction.force.norm(), (problem.force_unit() * force).norm(),
                        reaction.moment.norm() / problem.length_unit,
                        problem.force_unit() * moment.norm()});
    result.ends.push_back(reaction);
  }
  // pressure is a force too: the ends alone balance only without it
  if (!problem.seen.pressed() && largest > 0)
    balance.residual = (balance.support + balance.load).norm() / largest;
  result.balance.push_back(balance);
}

}  // namespace

Result solve_scene(const Scene& scene, const SolveOptions& options) {
  if (scene.joined()) return solve_join_scene(scene, options);
  const TubeProblem problem = read_problem(scene, options.model, options.law);
  const TubeMesh first = first_mesh(problem, options);
  TubeMesh finest = first;
  for (int k = 0; k < options.refine; ++k) finest = refined(finest, options);
  // A multiple of 192: the vertices of generated tubes with 24, 48 and 96 staggered points around
  // then lie on lines of this grid, where a comparison interpolates along the axis only.
  const int points_around = 192 * (1 + (2 * first.degree * finest.around - 1) / 192),
            stations = 2 * first.degree * finest.along + 1;

  Result result = begin_result(scene, options);
  Effort effort;
  const double start = now();
  const auto solve = [&](const TubeMesh& mesh) {
    Level level{mesh, solve_tube(problem, options.model, mesh, points_around, stations,
                                 options.stepper, options.processes)};
    const StepperSummary& summary = level.solution.summary;
    if (options.progress)
      options.progress(
          text("%s %d x %d cells, p = %d, %ld unknowns: %s at load %.4f, %d steps, %d iterations, "
               "energy %.10g",
               result.fidelity.c_str(), mesh.around, mesh.along, mesh.degree,
               level.solution.unknowns, to_string(summary.status).c_str(), summary.load,
               summary.steps, summary.iterations, summary.energy * problem.energy_unit()));
    return level;
  };
  const auto finer = [&](const TubeMesh& mesh) { return refined(mesh, options); };
  const auto left_out = [&](const Level& level) {
    result.certificate.notes.push_back(
        text("the mesh of %d x %d cells ended at load %.4f and is left out", level.mesh.around,
             level.mesh.along, level.solution.summary.load));
  };
  const std::vector<Level> levels =
      solve_levels(first, options.refine, effort, solve, finer, left_out);
  const Level& last = levels.back();
  const TubeSolution& solution = last.solution;
  result.certificate.notes.push_back("law: " + to_string(problem.law));
  note_prestress(problem.vessel, solution.seen, result);
  report_path(solution.summary, result);
  if (!solution.summary.positive_definite && solution.summary.status == PathStatus::complete)
    result.certificate.notes.push_back(
        "a dead moment on a freely turning section, or a pressure, has no energy: no minimum to "
        "certify");
  estimate_error(levels, last.mesh.degree, refinement_ratio(options), result);
  result.energy.strain = problem.energy_unit() * solution.summary.energy;
  report_ends(problem, solution, result);

  VesselResult vessel =
      vessel_result(problem.vessel, problem.shape, problem.length_unit, solution.wall);
  result.metrics.push_back(
      vessel_metrics(problem.shape, problem.length_unit, solution.wall, vessel));
  result.model.vertices = static_cast<int>(vessel.rest.rows());
  result.model.triangles = static_cast<int>(vessel.triangles.rows());
  result.model.terms = {result.fidelity, to_string(problem.law),
                        text("%d x %d cells", last.mesh.around, last.mesh.along)};
  result.vessels.push_back(std::move(vessel));
  effort.report(now() - start, result);
  return result;
}

}  // namespace vasorod::fem
