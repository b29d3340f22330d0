// Options common to all iterative solvers, and the check whether a solve should stop.
#pragma once

#include <chrono>
#include <cmath>
#include <functional>
#include <initializer_list>
#include <limits>
#include <optional>
#include <string>

namespace vasorod {

/// Progress of a solver.
struct SolverProgress {
  int outer = 0;        ///< multiplier updates so far
  int iterations = 0;   ///< sum over all minimisations so far
  double residual = 0;  ///< of the present state, in the solver's own measure
};

/// Time limit and callbacks of a solve.
struct SolverOptions {
  /// Wall-clock time limit in seconds.
  double time_limit = std::numeric_limits<double>::infinity();
  /// Called once per iteration, and about every millisecond within a factorisation; returning true
  /// interrupts. May be empty.
  std::function<bool()> stop;
  /// Called once per iteration. May be empty.
  std::function<void(const SolverProgress&)> progress;
};

/// Returns the sentence of the first failed check, in the given order; empty when all pass.
struct OptionCheck {
  bool good;
  const char* sentence;
};
inline std::optional<std::string> first_fault(std::initializer_list<OptionCheck> checks) {
  for (const OptionCheck& check : checks)
    if (!check.good) return check.sentence;
  return std::nullopt;
}

/// Decides whether a solve, begun at construction of this object, should stop: because the caller
/// asks for it or because its time limit is exceeded.
class StopCheck {
 public:
  explicit StopCheck(const SolverOptions& options) : options_(options) {}

  bool operator()() const {
    if (options_.stop && options_.stop()) return true;
    return std::isfinite(options_.time_limit) && seconds() > options_.time_limit;
  }
  /// The same, after reporting progress.
  bool operator()(const SolverProgress& progress) const {
    if (options_.progress) options_.progress(progress);
    return (*this)();
  }
  /// Wall-clock time since construction, seconds.
  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  const SolverOptions& options_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace vasorod
