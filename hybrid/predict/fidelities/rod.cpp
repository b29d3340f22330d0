#include "predict/fidelities/fidelities.h"

namespace vasorod {

void solve_rod_only(Prediction& prediction, const SolveOptions& /*options*/) {
  for (const PredictedVessel& vessel : prediction.vessels)
    if (vessel.rod_solved) prediction.work.counts += vessel.rod.summary.counts;
  prediction.left_out["surface"] = "fidelity rod: only the centerlines are asked for";
}

}  // namespace vasorod
