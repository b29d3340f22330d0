// Wall-clock time for the summaries.
#pragma once

#include <chrono>

namespace vasorod::fem {

/// Seconds of a monotonic clock.
inline double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace vasorod::fem
