// The path beyond a point where load steps end: steps of a given length in the displacements, the
// load following as it must, until it arrives at 1.
#pragma once

#include <vector>

#include "reference_fem/newton.h"

namespace vasorod::fem {

/// A converged state of the path; `from_last` is its difference to the newest one.
struct PathPoint {
  double load = 0;
  Eigen::VectorXd from_last;
};

/// Makes the state at `load`, `moved` from the newest one, the newest; three are kept.
void append(std::vector<PathPoint>& history, double load, const Eigen::VectorXd& moved);

/// Goes on from `state` with the help of the last two or three points of the path. On success
/// (true) the state is the one at load 1; else it is that of the largest load met.
bool follow_arc(const System& system, State& state, System::Assembly& assembly,
                std::vector<PathPoint> history, const StepperOptions& options,
                StepperSummary& summary);

}  // namespace vasorod::fem
