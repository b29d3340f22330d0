#include "paper/joined_skin.h"
#include "predict/fidelities/fidelities.h"
#include "predict/surface_bodies.h"

namespace vasorod {

void solve_skin(Prediction& prediction, const SolveOptions& /*options*/) {
  const auto positions = joined_skin(body_problem(prediction), &prediction.work);
  for (size_t v = 0; v < positions.size(); ++v) prediction.vessels[v].positions = positions[v];
  prediction.left_out["contact"] =
      "fidelity skin: sections are carried rigidly, nothing can yield to a pressure";
}

}  // namespace vasorod
