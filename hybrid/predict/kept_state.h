// The state of a prediction that is not finished, for programs that may have to end while a long
// step goes on (SolveOptions::keep).
#pragma once

#include "predict/prediction.h"

namespace vasorod {

/// The result with its seconds, the hashes of the inputs and the last look at its numbers.
Result whole_result(Prediction&& prediction, int threads);

/// Throws StoppedEarly: `stage` is what would come next, or what was cut.
[[noreturn]] void stop_early(const std::string& stage);

/// Hands the prediction to `options.keep`, if there is one: a fidelity's surfaces as far as they
/// are solved. Its status becomes interrupted.
void keep_state(Prediction&& state, const SolveOptions& options);

/// The same before the fidelity solves anything: the rods are solved and carry their sections
/// rigidly. The relative residual is unknown.
void keep_rods(const Prediction& prediction, const SolveOptions& options);

}  // namespace vasorod
