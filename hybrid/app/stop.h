// Signals and the time limit, combined in one stop function for the solvers.
#pragma once

#include <functional>
#include <string>

namespace vasorod {

/// Installs handlers for SIGINT, SIGTERM and SIGHUP. The first signal sets a flag; the second ends
/// the process at once with exit code 128 + signal and leaves no half-written result. SIGHUP stays
/// ignored if it was (nohup). Returns a function that is true once the flag is set or `seconds`
/// (0: no limit) have passed since this call.
std::function<bool()> stop_on_signal_or_after(double seconds);

/// What the function of stop_on_signal_or_after(seconds) stopped by: "a signal" or "the time limit
/// of 5 s".
std::string stopped_by_signal_or(double seconds);

/// Installs handlers with which the first of these signals ends the process in that way.
void end_on_signal();

}  // namespace vasorod
