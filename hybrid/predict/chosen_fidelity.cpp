#include "predict/chosen_fidelity.h"

#include <vasorod/error.h>

namespace vasorod {
namespace {

bool is_certified(const SolvedSurfaces& surfaces) {
  return surfaces.smallest_curvature_positive.value_or(false) &&
         surfaces.solution.status <= Status::equilibrium_only;
}

}  // namespace

const Fidelity& solve_chosen(const Fidelity& chosen, const Fidelity& dearest,
                             Prediction& prediction, const SolveOptions& options) {
  if (!chosen.partial) {
    chosen.solve(prediction, options);
    return chosen;
  }
  Prediction before = prediction;
  std::string reason;
  try {
    chosen.solve(prediction, options);
    const SolvedSurfaces& found = prediction.surfaces.value();
    // A solve that was stopped is the best state there is time for.
    if (is_certified(found) || found.solution.status == Status::interrupted) return chosen;
    reason = "it ended as " + to_string(found.solution.status);
    before.work = prediction.work;
  } catch (const InputError& error) {
    reason = error.what();
  }
  prediction = std::move(before);
  prediction.fidelity = dearest.name;
  prediction.notes.push_back("fidelity " + chosen.name + ", which the accuracy chose, was left: " +
                             reason + "; fidelity " + dearest.name + " solves without a promise");
  options.progress("fidelity " + dearest.name);
  dearest.solve(prediction, options);
  return dearest;
}

}  // namespace vasorod
