// The work of a solver: what it counts, and the time of its factorisations.
#pragma once

#include <chrono>

#include <vasorod/counts.h>

namespace vasorod {

/// What a solver did so far. Its parts add to one such object.
struct Work {
  Counts counts;
  /// Wall-clock seconds of orderings, symbolic analyses and numerical factorisations.
  double factor_seconds = 0;

  Work& operator+=(const Work& other) {
    counts += other.counts;
    factor_seconds += other.factor_seconds;
    return *this;
  }
};

/// Adds the time of its own life to Work::factor_seconds; `work` may be null.
class FactorTime {
 public:
  explicit FactorTime(Work* work) : work_(work) {}
  ~FactorTime() {
    if (work_)
      work_->factor_seconds +=
          std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }
  FactorTime(const FactorTime&) = delete;
  FactorTime& operator=(const FactorTime&) = delete;

 private:
  Work* work_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace vasorod
