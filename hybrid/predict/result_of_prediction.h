// Converts a prediction to a result.
#pragma once

#include "predict/prediction.h"

namespace vasorod {

/// The result without seconds and without the hashes of the inputs.
Result result_of(const Prediction& prediction, int threads);

}  // namespace vasorod
