#include "reference_fem/solve_join_scene.h"

#include <algorithm>
#include <cmath>

#include <vasorod/error.h>

#include "reference_fem/clock.h"
#include "reference_fem/join_result.h"
#include "reference_fem/solve_parts.h"

namespace vasorod::fem {
namespace {

constexpr double ratio = 1.5;  // of the cells' sizes on one mesh and the next

struct Level {
  JoinCells cells;
  JoinSolution solution;
  double mouth = 0;  ///< its area, length^2
};

JoinCells cells_of(const JoinProblem& problem, const SolveOptions& options) {
  check_options(options);
  const bool solid = options.model == ModelKind::solid;
  if (solid && options.degree == 1)
    throw InputError("--degree: found 1, expected 2 to 4 for a join's solid, as one locks");
  if (!options.mesh.empty())
    throw InputError("--mesh: found " + options.mesh + ", expected --cells for a join");
  const int multiple = 1 << options.refine,  // so that every refinement by 3/2 gives integers
      around = options.around == 0 ? 16 : options.around;
  if (around < 4 || around % (4 * multiple) != 0 || options.along < 0 ||
      options.along % multiple != 0)
    throw InputError("--cells: found " + std::to_string(around) + " x " +
                     std::to_string(options.along) + ", expected for a join with --refine " +
                     std::to_string(options.refine) + " multiples of " +
                     std::to_string(4 * multiple) + " around the seam and of " +
                     std::to_string(multiple) + " along the vein");
  JoinCells cells = first_cells(problem, around / 4, options.along, multiple);
  cells.degree = options.degree;
  if (solid) cells.layers = 2;  // nodes at the mid-wall, for every degree
  return cells;
}

/// Changes between two meshes: displacements (root mean square over the cut's radius), reactions,
/// energy and the mouth's area (relative).
struct Change {
  double displacement = 0, reaction = 0, energy = 0, mouth = 0;
};

double squares(const MidWall& a, const MidWall& b) {
  return ((a.current - a.rest) - (b.current - b.rest)).squaredNorm();
}

Change change(const Level& fine, const Level& coarse) {
  const JoinSolution &a = fine.solution, &b = coarse.solution;
  Change out;
  out.displacement = std::sqrt((squares(a.vein, b.vein) + squares(a.artery, b.artery)) /
                               static_cast<double>(a.vein.rest.rows() + a.artery.rest.rows()));
  double size = 0;
  for (const auto& [mine, other] :
       {std::pair{&a.on_vein, &b.on_vein}, std::pair{&a.on_artery, &b.on_artery}})
    for (std::size_t e = 0; e < mine->ends.size(); ++e)
      for (Vec3 JoinForces::End::*load : {&JoinForces::End::force, &JoinForces::End::moment}) {
        const Vec3 &x = mine->ends[e].*load, &y = other->ends[e].*load;
        out.reaction = std::max(out.reaction, (x - y).cwiseAbs().maxCoeff());
        size = std::max(size, x.cwiseAbs().maxCoeff());
      }
  if (size > 0) out.reaction /= size;
  out.energy = std::abs(a.summary.energy / b.summary.energy - 1);
  out.mouth = std::abs(fine.mouth / coarse.mouth - 1);
  return out;
}

// The slit's tips are singular points: no order above 2 is believed (refinement.h).
void estimate_error(const std::vector<Level>& levels, Result& result) {
  result.discretisation.emplace();
  result.discretisation->dofs = levels.back().solution.unknowns;
  result.discretisation->degree = levels.back().cells.degree;
  if (levels.size() < 2) return;
  const std::size_t n = levels.size();
  const Change fine = change(levels[n - 1], levels[n - 2]);
  std::optional<Change> coarse;
  if (n > 2) coarse = change(levels[n - 2], levels[n - 3]);
  double largest = 0;
  const auto note = [&](const char* what, double Change::*member) {
    const Convergence c = grid_convergence(
        fine.*member, coarse ? std::optional<double>((*coarse).*member) : std::nullopt, ratio, 2);
    largest = std::max(largest, c.uncertainty);
    result.certificate.notes.push_back(error_note(what, c, ratio));
    return c;
  };
  note("displacements over the cut's radius (RMS)", &Change::displacement);
  note("reactions, relative", &Change::reaction);
  result.discretisation->observed_order = note("energy, relative", &Change::energy).observed_order;
  note("mouth's area, relative", &Change::mouth);
  result.discretisation->error_estimate = largest;
}

std::string name_of(const JoinProblem& problem, const JoinCells& cells) {
  if (problem.other_rim)
    return text("%d cells around the seam, %d along %s, %d along %s", 4 * cells.seam, cells.vein,
                problem.vein.name.c_str(), cells.after, problem.artery.name.c_str());
  return text("%d cells around the seam, %d along the vein, %d around and %d along the artery",
              4 * cells.seam, cells.vein, 2 * cells.around,
              2 * cells.seam + cells.before + cells.after);
}

std::string part_of(const JoinProblem& problem) {
  if (problem.copies() == 4) return "a quarter";
  return problem.copies() == 2 ? "a half" : "the whole";
}

}  // namespace

Result solve_join_scene(const Scene& scene, const SolveOptions& options) {
  const JoinProblem problem = read_join(scene, options.law);
  const JoinCells first = cells_of(problem, options);
  const JoinSampling sampling = sampling_for(problem, first);
  const double energy_unit = problem.units.moment();

  Result result = begin_result(scene, options);
  Effort effort;
  const double start = now();
  const auto solve = [&](const JoinCells& cells) {
    Level level{cells, solve_join(problem, cells, sampling, options.stepper, options.processes), 0};
    level.mouth = join_mouth(problem, level.solution).area;
    const StepperSummary& summary = level.solution.summary;
    if (options.progress)
      options.progress(
          text("%s: p = %d, %ld unknowns: %s at %.4f of the way, %d steps, %d "
               "iterations, energy %.8g, mouth %.6g",
               name_of(problem, cells).c_str(), cells.degree, level.solution.unknowns,
               to_string(summary.status).c_str(), summary.load, summary.steps, summary.iterations,
               summary.energy * energy_unit, level.mouth));
    return level;
  };
  const auto finer = [](const JoinCells& cells) { return refined(cells, ratio); };
  const auto left_out = [&](const Level& level) {
    result.certificate.notes.push_back("the mesh of " + name_of(problem, level.cells) +
                                       " did not reach the closed seam and is left out");
  };
  const std::vector<Level> levels =
      solve_levels(first, options.refine, effort, solve, finer, left_out);
  const Level& last = levels.back();
  const JoinSolution& solution = last.solution;
  result.certificate.notes.push_back("laws: " + to_string(problem.vein.law) + " of " +
                                     problem.vein.name + ", " + to_string(problem.artery.law) +
                                     " of " + problem.artery.name);
  note_prestress(problem.vein.name, solution.seen.vein, result);
  note_prestress(problem.artery.name, solution.seen.artery, result);
  report_path(solution.summary, result);
  if (problem.copies() > 1)
    result.certificate.notes.push_back(
        "modelled: " + part_of(problem) +
        " of the scene; a state that breaks its symmetry is not looked for");
  estimate_error(levels, result);
  result.energy.strain = energy_unit * solution.summary.energy;
  report_join(problem, solution, result);
  result.model.terms = {result.fidelity, "joining", name_of(problem, last.cells)};
  effort.report(now() - start, result);
  return result;
}

}  // namespace vasorod::fem
