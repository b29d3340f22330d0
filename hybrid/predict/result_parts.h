// How every result begins and what it says of a solved rod, whatever was solved.
#pragma once

#include <vasorod/predict.h>

#include "rod/newton.h"

namespace vasorod {

/// Names, units, program and environment; everything else at its default.
Result begin_result(const std::string& scene, const std::string& fidelity, const Units& units,
                    int threads);

/// The larger; what is not a number stays, as std::max would leave it out.
double worst_of(double a, double b);

/// Adds a rod's status, residual, energy, iterations and message ("rod of NAME: ...").
/// `certificate`: the sign of its smallest curvature counts for the whole.
void add_rod(const std::string& name, const RodSummary& summary, bool certificate, Result& result);

}  // namespace vasorod
