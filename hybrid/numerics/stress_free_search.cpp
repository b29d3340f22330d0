#include "numerics/stress_free_search.h"

#include <algorithm>
#include <array>
#include <utility>

#include "numerics/anderson.h"

namespace vasorod {
namespace {

using Eigen::VectorXd;

// Shares of the load that are reached one after the other, if fewer do not lead to the shape.
constexpr std::array<int, 3> ways{1, 4, 16};
// For each share: steps, and differences that are remembered.
constexpr int most_steps = 80, memory = 20;
// Steps over the displacement at which the search ends, and at which a share is reached of which
// others follow.
constexpr double tolerance = 1e-11, rough = 1e-2;
// Displacements are at least this long there: a prestretch of a straight tube needs none.
constexpr double least_length = 0.1;

bool reach(StressFreeProblem& problem, double share, double until, VectorXd& x, int& steps,
           const std::function<bool()>& stop) {
  Anderson accelerated(memory);
  for (int own = 0; own < most_steps; ++own) {
    if (stop && stop()) return false;
    ++steps;
    if (!problem.set(share, x)) return false;
    const VectorXd step = problem.step(x);
    if (!step.allFinite()) return false;
    x = accelerated.next(x, step);
    if (problem.length(step) <= until * std::max(problem.length(x), least_length)) return true;
  }
  return false;
}

}  // namespace

int search_stress_free(StressFreeProblem& problem, VectorXd& x, const std::function<bool()>& stop) {
  int steps = 0;
  for (const int shares : ways) {
    VectorXd found = VectorXd::Zero(x.size());
    bool reached = true;
    for (int i = 1; reached && i <= shares; ++i) {
      found = i == 1 ? VectorXd(x / shares) : VectorXd(found * i / (i - 1));
      reached = reach(problem, static_cast<double>(i) / shares, i == shares ? tolerance : rough,
                      found, steps, stop);
    }
    if (!reached) continue;
    x = std::move(found);
    return steps;
  }
  return 0;
}

}  // namespace vasorod
