// How every result begins and what it says of a solved rod, whatever was solved.
#pragma once

#include <vasorod/predict.h>

#include "rod/newton.h"

namespace vasorod {

/// Names, units, program and environment; everything else at its default.
Result begin_result(const std::string& scene, const std::string& fidelity, const Units& units,
                    int threads);

/// Adds a rod's status, residual, energy, iterations and message ("rod of NAME: ...").
/// `certificate`: the sign of its smallest curvature counts for the whole.
void add_rod(const std::string& name, const RodSummary& summary, bool certificate, Result& result);

/// SHA-256 of the scene file and of every surface file it names, by file name, or by path where two
/// have one name. Throws FileError.
void add_input_hashes(const Scene& scene, Result& result);

}  // namespace vasorod
