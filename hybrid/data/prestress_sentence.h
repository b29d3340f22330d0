// What a result says of a prestress that is large; the reference's results say it in the same
// words.
#pragma once

#include <optional>
#include <string>

namespace vasorod {

/// The sentence about a prestress of a displacement so large that the linear one is rough; empty:
/// it is not. `share`: its largest length over the vessel's radius. `steps`: in which the shape
/// without stress was found; 0: it was not; empty: it was not looked for.
std::optional<std::string> large_prestress(const std::string& vessel, double share,
                                           std::optional<int> steps);

}  // namespace vasorod
