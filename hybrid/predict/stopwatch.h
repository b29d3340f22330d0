// Wall-clock seconds of named stages, for result.json.
#pragma once

#include <chrono>
#include <map>
#include <string>

namespace vasorod {

/// Measures stages one after the other.
class Stopwatch {
 public:
  /// Adds the time since construction or the last call to `stage`, s.
  void lap(const std::string& stage) {
    const auto now = std::chrono::steady_clock::now();
    seconds_[stage] += std::chrono::duration<double>(now - last_).count();
    last_ = now;
  }
  /// The seconds of all stages and their `total`.
  std::map<std::string, double> seconds() const {
    auto all = seconds_;
    double total = 0;
    for (const auto& [stage, value] : all) total += value;
    all["total"] = total;
    return all;
  }

 private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
  std::map<std::string, double> seconds_{
      {"read", 0}, {"fit", 0}, {"factor", 0}, {"solve", 0}, {"write", 0}};
};

}  // namespace vasorod
