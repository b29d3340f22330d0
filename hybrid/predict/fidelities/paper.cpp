#include "paper/paper_solver.h"
#include "predict/fidelities/fidelities.h"
#include "predict/kept_state.h"
#include "predict/surface_bodies.h"

namespace vasorod {
namespace {

void take(SurfaceSolution&& solution, const SolveOptions& options, Prediction& prediction) {
  SolvedSurfaces surfaces;
  surfaces.solution = std::move(solution);
  if (options.certify)
    surfaces.smallest_curvature_positive = surfaces.solution.smallest_curvature_positive;
  surfaces.notes = surfaces.solution.notes;
  surfaces.terms = {"binding", "bending", "stretching"};
  take_surfaces(std::move(surfaces), "surface", prediction);
}

}  // namespace

void solve_paper_surfaces(Prediction& prediction, const SolveOptions& options) {
  PaperOptions paper;
  paper.certify = options.certify;
  paper.stop = options.stop;
  paper.step = step_progress("surfaces", options);
  paper.progress = iteration_progress("surfaces", 50, options);
  paper.keep = keep_for<SurfaceSolution>(prediction, options,
                                         [&](SurfaceSolution&& so_far, Prediction& state) {
                                           take(std::move(so_far), options, state);
                                         });
  take(solve_paper(body_problem(prediction), paper), options, prediction);
}

}  // namespace vasorod
