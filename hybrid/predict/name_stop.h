// What a result that was interrupted says of its end.
#pragma once

#include <string>

#include <vasorod/result.h>

namespace vasorod {

/// "the time limit of 5 s"
std::string time_limit_of(double seconds);

/// Adds to an interrupted result's notes the sentence that says what it was stopped by
/// (SolveOptions::stopped_by) and at which stage.
void name_stop(const std::string& by, const std::string& stage, Result& result);

}  // namespace vasorod
