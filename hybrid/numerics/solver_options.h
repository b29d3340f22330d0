// What every iterative solver takes, and how it is asked to stop.
#pragma once

#include <chrono>
#include <cmath>
#include <functional>
#include <initializer_list>
#include <limits>
#include <optional>
#include <string>

namespace vasorod {

/// How far a solver is.
struct SolverProgress {
  int outer = 0;        ///< multiplier updates so far
  int iterations = 0;   ///< of all minimisations so far
  double residual = 0;  ///< of the present state, as the solver measures it
};

struct SolverOptions {
  double time_limit = std::numeric_limits<double>::infinity();  ///< seconds of wall clock
  std::function<bool()> stop;  ///< asked once an iteration; true interrupts
  std::function<void(const SolverProgress&)> progress;  ///< told once an iteration; may be empty
};

/// The first sentence that is wrong, of those given in order: {is it right, what to say where not}.
struct OptionCheck {
  bool good;
  const char* sentence;
};
inline std::optional<std::string> first_fault(std::initializer_list<OptionCheck> checks) {
  for (const OptionCheck& check : checks)
    if (!check.good) return check.sentence;
  return std::nullopt;
}

/// Asks whether a solve that began at construction should end: the caller says so, or its time is
/// up.
class StopCheck {
 public:
  explicit StopCheck(const SolverOptions& options) : options_(options) {}

  bool operator()() const {
    if (options_.stop && options_.stop()) return true;
    return std::isfinite(options_.time_limit) && seconds() > options_.time_limit;
  }
  /// The same, after telling how far the solver is.
  bool operator()(const SolverProgress& progress) const {
    if (options_.progress) options_.progress(progress);
    return (*this)();
  }
  /// Wall clock since construction.
  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  const SolverOptions& options_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace vasorod
