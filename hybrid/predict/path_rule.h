// Decides when `coupled` follows a motion in steps and does not jump to its end, and the steps.
#pragma once

#include <vector>

#include "predict/prediction.h"

namespace vasorod {

/// How close the solved rods come to their walls' limits, where the smooth branch may end:
/// Brazier's curvature for vessels of any length (k R^2 / (0.605 t) converted to 0.471 t / (R^2
/// sqrt(1 - nu^2))), and the twist of wrinkling. Soft sections can flatten and count double. 1: at
/// the limit.
double share_of_limit(const Prediction& prediction);

/// The times, up to 1, of the steps of a motion that ends at this share of the limit. From 0.7 of
/// the limit on, a smooth and a kinked minimum coexist. At half the limit there is one minimum;
/// from there, the path advances in small steps, each extrapolated from the previous two.
std::vector<double> path_times(double share);

/// The times for a prediction. An operation jumps: its pose is only a start, and no path leads from
/// rest to it.
std::vector<double> path_times(const Prediction& prediction);

}  // namespace vasorod
