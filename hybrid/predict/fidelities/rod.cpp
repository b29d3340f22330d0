#include "predict/fidelities/fidelities.h"

namespace vasorod {

void solve_rod_only(Prediction& prediction, const SolveOptions& /*options*/) {
  prediction.left_out["surface"] = "fidelity rod: only the centerlines are asked for";
}

}  // namespace vasorod
