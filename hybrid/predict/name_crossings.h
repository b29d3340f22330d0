// The last check of a result: no wall passes through itself or another and says converged.
#pragma once

#include <string>
#include <vector>

#include <vasorod/result.h>

#include "predict/prediction.h"

namespace vasorod {

/// Where the predicted surfaces pass through themselves or each other; in fidelity rod those that
/// the rods carry, without what two joined vessels do, whose seam nothing closed.
std::vector<NamedCrossing> named_crossings(const Prediction& prediction);

/// The depth of the deepest of them, length; 0: there is none. They stay in `crossings`.
double deepest_crossing(Prediction& prediction);

/// Fills `self_intersections` from the predicted surfaces, with a warning for each, and puts the
/// validity out of range. Where surfaces were solved, the status becomes self_intersecting at
/// least; a fidelity that only carries them does not claim that they are apart. States that were
/// interrupted are not searched. Where the vein of an operation is among them and is bent too
/// sharply, a note of the certificate says what would do (sharp_vein.h).
void name_crossings(const Prediction& prediction, Result& result);

}  // namespace vasorod
