// What solving a tube and solving a join share: checks of the options, one mesh after another, and
// what a path and an error estimate say in a result.
#pragma once

#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "reference_fem/prestress.h"
#include "reference_fem/refinement.h"
#include "reference_fem/solve_scene.h"

namespace vasorod::fem {

/// printf to a string.
template <class... Values>
std::string text(const char* format, Values... values) {
  char buffer[256];
  std::snprintf(buffer, sizeof buffer, format, values...);
  return buffer;
}

/// Throws InputError for a degree or a number of refinements out of range.
void check_options(const SolveOptions& options);

/// A result with the scene's name and units and the model's fidelity.
Result begin_result(const Scene& scene, const SolveOptions& options);

/// What the meshes took together.
struct Effort {
  double mesh = 0, assembly = 0, factor = 0;  ///< s
  int iterations = 0;
  Counts counts;

  void add(const StepperSummary& summary, double mesh_seconds);
  /// `solve`: seconds from the first mesh to the result.
  void report(double solve, Result& result) const;
};

/// Solves on `mesh` and on `refinements` finer ones, until one does not reach the whole load. An
/// unfinished finer mesh does not replace a finished one: `left_out(level)` is called instead.
/// `solve` makes a level, which has a `solution`, from a mesh.
template <class Mesh, class Solve, class Refine, class LeftOut>
auto solve_levels(Mesh mesh, int refinements, Effort& effort, Solve&& solve, Refine&& refine,
                  LeftOut&& left_out) {
  std::vector<decltype(solve(mesh))> levels;
  for (int k = 0; k <= refinements; ++k) {
    auto level = solve(mesh);
    const StepperSummary& summary = level.solution.summary;
    effort.add(summary, level.solution.mesh_seconds);
    const bool complete = summary.status == PathStatus::complete;
    if (complete || levels.empty())
      levels.push_back(std::move(level));
    else
      left_out(level);
    if (!complete) break;
    if (k < refinements) mesh = refine(mesh);
  }
  return levels;
}

/// Status, certificate and notes of the path.
void report_path(const StepperSummary& summary, Result& result);

/// A note where a linear prestress of the wall would be rough.
void note_prestress(const std::string& vessel, const SeenShare& seen, Result& result);

/// "u_num of WHAT: ...".
std::string error_note(const std::string& what, const Convergence& convergence, double ratio);

}  // namespace vasorod::fem
