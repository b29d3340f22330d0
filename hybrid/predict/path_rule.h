// When `coupled` follows the way of the motions instead of jumping to its end, and in which steps.
#pragma once

#include <vector>

#include "predict/prediction.h"

namespace vasorod {

/// How near the solved rods come to their walls' limits, where the smooth branch may end: of
/// Brazier's curvature whatever the vessel's length (k R^2 / (0.605 t) counted in 0.471 t / (R^2
/// sqrt(1 - nu^2))), and of the twist that wrinkles. Soft sections, free to flatten, count double.
/// 1: at the limit.
double share_of_limit(const Prediction& prediction);

/// The times, up to 1, at which a motion that ends at this share of the limit is followed. From 0.7
/// of the limit on a smooth and a kinked minimum coexist. At half the limit only one is left; the
/// path goes from there in small steps, each extrapolated from the two before.
std::vector<double> path_times(double share);

/// The same for a prediction. An operation jumps: its pose is no more than a start, and no path
/// leads from rest to it.
std::vector<double> path_times(const Prediction& prediction);

}  // namespace vasorod
