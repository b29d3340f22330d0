// Each vessel's part of a result: arrays, centerline, metrics, validity.
#pragma once

#include "app/prediction.h"

namespace vasorod {

/// Fills result.vessels, result.metrics, result.validity and result.stages.
void add_vessels(const Prediction& prediction, Result& result);

/// What `fit` writes of one vessel: its surface as read, its centerline and rod at rest.
Result fitted_result(const std::string& name, const LoadedSurface& loaded, const Vessel& vessel);

}  // namespace vasorod
