// Follows the path beyond the point where load steps fail: steps of a given length in the
// displacements, with the load as an unknown, until the load is 1.
#pragma once

#include <vector>

#include "reference_fem/newton.h"

namespace vasorod::fem {

/// A converged state of the path.
struct PathPoint {
  double load = 0;            ///< share of the full load
  Eigen::VectorXd from_last;  ///< unknowns relative to the newest state
};

/// Appends the state at `load`, `moved` from the newest one. The last three states are kept.
void append(std::vector<PathPoint>& history, double load, const Eigen::VectorXd& moved);

/// Continues from `state` with the last two or three points of the path. True: the state is the one
/// at load 1. False: the state is that of the largest load reached.
bool follow_arc(const System& system, State& state, System::Assembly& assembly,
                std::vector<PathPoint> history, const StepperOptions& options,
                StepperSummary& summary);

}  // namespace vasorod::fem
