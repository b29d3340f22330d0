// What a result that was interrupted, or whose search for a better one was, says of its end.
#pragma once

#include <string>

#include <vasorod/result.h>

namespace vasorod {

/// "the time limit of 5 s"
std::string time_limit_of(double seconds);

/// Adds to a result's notes the sentence that says what it was stopped by
/// (SolveOptions::stopped_by) and at which stage: an interrupted one, or one that is
/// `iteration_limit`, `unstable` or `self_intersecting`, for which other ways were still being
/// tried. Of the others nothing was cut off.
void name_stop(const std::string& by, const std::string& stage, Result& result);

}  // namespace vasorod
