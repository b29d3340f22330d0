#include <algorithm>

#include "paper/paper_solver.h"
#include "predict/carried_bodies.h"
#include "predict/fidelities/fidelities.h"
#include "predict/kept_state.h"
#include "predict/name_crossings.h"
#include "predict/surface_bodies.h"

namespace vasorod {
namespace {

// Of a vein that folds: contacts that are still found differently after this many updates stick,
// and penalties stiff enough for walls that are pressed together.
constexpr int hold_after = 6;
constexpr double contact_stiffness = 10;

void take(SurfaceSolution&& solution, const SolveOptions& options, Prediction& prediction) {
  SolvedSurfaces surfaces;
  surfaces.solution = std::move(solution);
  if (options.certify)
    surfaces.smallest_curvature_positive = surfaces.solution.smallest_curvature_positive;
  surfaces.notes = surfaces.solution.notes;
  surfaces.terms = {"binding", "bending", "stretching"};
  take_surfaces(std::move(surfaces), "surface", prediction);
}

PaperOptions paper_options(const Prediction& prediction, const SolveOptions& options) {
  PaperOptions paper;
  paper.certify = options.certify;
  paper.stop = options.stop;
  paper.step = step_progress("surfaces", options);
  paper.progress = iteration_progress("surfaces", 50, options);
  paper.keep = keep_for<SurfaceSolution>(prediction, options,
                                         [&options](SurfaceSolution&& so_far, Prediction& state) {
                                           take(std::move(so_far), options, state);
                                         });
  return paper;
}

// Along the way of a vein that folds.
SurfaceSolution solve_from_rest(const Prediction& prediction, const SolveOptions& options) {
  BodyProblem problem = body_problem(prediction);
  const auto path = std::make_shared<const JoiningPath>(prediction);
  PaperWay way;
  way.seam = start_at_rest(prediction, path, problem);
  way.carried = [&prediction, path, none = std::vector<VesselSections>(prediction.vessels.size())](
                    double t) { return carried_by_rods(prediction, none, t, path.get()); };
  PaperOptions paper = paper_options(prediction, options);
  paper.hold_after = hold_after;
  paper.contact_stiffness = contact_stiffness;
  return PaperSolver(paper).solve(problem, &way);
}

}  // namespace

// The sections of a vein that has to fold pass through each other, and the surface that is bound to
// them does too where it starts there. Then it goes the way from rest, on which it feels itself.
void solve_paper_surfaces(Prediction& prediction, const SolveOptions& options) {
  Prediction closed = prediction;
  take(solve_paper(body_problem(prediction), paper_options(prediction, options)), options, closed);
  prediction.work = closed.work;
  const bool solved = closed.surfaces->solution.status != Status::interrupted;
  // In a scene in which nothing touches anything, walls may lie in each other.
  const auto& contact = prediction.scene->contact;
  const bool touches = !contact || !contact->empty();
  const double depth = solved && closed.operation && touches ? deepest_crossing(closed) : 0;
  if (depth > 0 && !options.stop()) {
    Prediction folded = prediction;
    take(solve_from_rest(prediction, options), options, folded);
    const Status status = folded.surfaces->solution.status;
    if (status == Status::converged && deepest_crossing(folded) < depth) {
      prediction = std::move(folded);
      return;
    }
    closed.work = folded.work;
    closed.surfaces->notes.push_back(
        "the way from rest, on which the vein feels itself, " +
        std::string(status == Status::converged     ? "ended as deep in a wall"
                    : status == Status::interrupted ? "was interrupted"
                                                    : "led to no equilibrium") +
        (folded.surfaces->notes.empty() ? "" : ": " + folded.surfaces->notes.back()));
  }
  prediction = std::move(closed);
}

}  // namespace vasorod
