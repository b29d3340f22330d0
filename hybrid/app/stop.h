// Ctrl-C and the time limit as one question a solver can ask.
#pragma once

#include <functional>

namespace vasorod {

/// From now on SIGINT and SIGTERM only raise a flag. Returns a function that is true once the flag
/// is up or `seconds` (0: no limit) have passed since this call.
std::function<bool()> stop_on_signal_or_after(double seconds);

}  // namespace vasorod
