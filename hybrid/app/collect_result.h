// From a prediction to the result folder's data.
#pragma once

#include "app/prediction.h"

namespace vasorod {

/// Everything but seconds, threads and input hashes, which the caller knows.
Result collect_result(const Prediction& prediction);

}  // namespace vasorod
