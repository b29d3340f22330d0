// Parts that all results share: the header and the summary of a solved rod.
#pragma once

#include <vasorod/predict.h>

#include "rod/newton.h"

namespace vasorod {

/// Names, units, program and environment. Everything else has its default.
Result begin_result(const std::string& scene, const std::string& fidelity, const Units& units,
                    int threads);

/// The larger of two values. Not-a-number is kept; std::max would lose it.
double worst_of(double a, double b);

/// Adds a rod's status, residual, energy, iterations and message ("rod of NAME: ...").
/// `certificate`: the sign of the rod's smallest curvature is part of the result's certificate.
void add_rod(const std::string& name, const RodSummary& summary, bool certificate, Result& result);

}  // namespace vasorod
