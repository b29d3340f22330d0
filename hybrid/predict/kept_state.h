// The state of a prediction that is not finished, for programs that may have to end while a long
// step goes on (SolveOptions::keep).
#pragma once

#include <functional>
#include <utility>

#include "predict/prediction.h"

namespace vasorod {

/// The result with its seconds, the hashes of the inputs and the last look at its numbers.
Result whole_result(Prediction&& prediction, int threads);

/// Throws StoppedEarly: `stage` is what would come next, or what was cut.
[[noreturn]] void stop_early(const std::string& stage);

/// Hands the prediction to `options.keep`, if there is one: a fidelity's surfaces as far as they
/// are solved. Its status becomes interrupted.
void keep_state(Prediction&& state, const SolveOptions& options);

/// The `keep` of a fidelity's solver: `take(solution, state)` puts what is solved so far into a
/// copy of the prediction. Empty where nobody wants states. Refers to its arguments but `take`.
template <class Solution, class Take>
std::function<void(Solution&&)> keep_for(const Prediction& prediction, const SolveOptions& options,
                                         Take take) {
  if (!options.keep) return {};
  return [&prediction, &options, take](Solution&& so_far) {
    Prediction state = prediction;
    take(std::move(so_far), state);
    keep_state(std::move(state), options);
  };
}

/// The same before the fidelity solves anything: the rods are solved and carry their sections
/// rigidly. The relative residual is unknown.
void keep_rods(const Prediction& prediction, const SolveOptions& options);

}  // namespace vasorod
