// Each vessel's part of a result: arrays, centerline, metrics, validity.
#pragma once

#include "predict/prediction.h"

namespace vasorod {

/// The centerline for the result: a whole rod with these poses.
CenterlineResult centerline_of(const RodTree& rod, const RodPoses& poses);

/// Fills result.vessels, result.metrics, result.validity and result.stages.
void add_vessels(const Prediction& prediction, Result& result);

}  // namespace vasorod
