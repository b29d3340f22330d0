// Each vessel's part of a result: arrays, centerline, metrics, validity.
#pragma once

#include "app/prediction.h"

namespace vasorod {

/// Fills result.vessels, result.metrics, result.validity and result.stages.
void add_vessels(const Prediction& prediction, Result& result);

}  // namespace vasorod
