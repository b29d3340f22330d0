// Signals and the time limit as one question a solver can ask.
#pragma once

#include <functional>

namespace vasorod {

/// From now on the first SIGINT, SIGTERM or SIGHUP only raises a flag; the second ends the process
/// at once, with exit code 128 + signal and without a half-written result. A SIGHUP that was
/// ignored (nohup) stays so. Returns a function that is true once the flag is up or `seconds` (0:
/// no limit) have passed since this call.
std::function<bool()> stop_on_signal_or_after(double seconds);

/// From now on the first of them ends the process so.
void end_on_signal();

}  // namespace vasorod
