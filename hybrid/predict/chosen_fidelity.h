// Solves with the fidelity that `accuracy:` chose.
#pragma once

#include "predict/fidelity.h"

namespace vasorod {

/// Solves with `chosen`. Where that is a partial fidelity which refuses a vessel or ends without a
/// certified minimum, `dearest` solves from the same state, and a note says why. Returns the one
/// that solved.
const Fidelity& solve_chosen(const Fidelity& chosen, const Fidelity& dearest,
                             Prediction& prediction, const SolveOptions& options);

}  // namespace vasorod
