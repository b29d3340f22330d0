#include "paper/paper_solver.h"
#include "predict/fidelities/fidelities.h"
#include "predict/surface_bodies.h"

namespace vasorod {

void solve_paper_surfaces(Prediction& prediction, const SolveOptions& options) {
  PaperOptions paper;
  paper.certify = options.certify;
  paper.stop = options.stop;
  paper.progress = iteration_progress("surfaces", 50, options);
  SolvedSurfaces surfaces;
  surfaces.solution = solve_paper(body_problem(prediction), paper);
  if (options.certify)
    surfaces.smallest_curvature_positive = surfaces.solution.smallest_curvature_positive;
  surfaces.notes = surfaces.solution.notes;
  surfaces.terms = {"binding", "bending", "stretching"};
  take_surfaces(std::move(surfaces), "surface", prediction);
}

}  // namespace vasorod
