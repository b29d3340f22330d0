// The last look at a result: what must never be green is not, and says why.
#pragma once

#include <vasorod/result.h>

namespace vasorod {

/// Where a number of the result is not finite its status is at least iteration_limit, it is not in
/// the model's range and has no certificate, and a note names the numbers. Numbers that say "there
/// is none" do not count: the seam and the opened area of a result without surfaces, the gap of
/// walls that do not face each other. An iteration_limit that no note explains gets one with its
/// residual.
void name_faults(Result& result);

}  // namespace vasorod
