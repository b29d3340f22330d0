// From vessels with their rods and end conditions to a prediction that a fidelity can solve.
#pragma once

#include <functional>
#include <string>

#include "predict/fidelity.h"
#include "predict/prediction.h"

namespace vasorod {

/// Finds the stress that the vessels were seen with, carries out the scene's operation, and solves
/// the rods. `begin`: called before each stage; it may throw to end. Throws InputError.
void get_ready(Prediction& prediction, LumenOf lumen, const SolveOptions& options,
               const std::function<void(const std::string&)>& begin);

}  // namespace vasorod
