// From a prediction to the result's data.
#pragma once

#include "predict/prediction.h"

namespace vasorod {

/// Everything but seconds and the hashes of the inputs.
Result result_of(const Prediction& prediction, int threads);

}  // namespace vasorod
