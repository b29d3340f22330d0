// The options as a table, options.csv.
#pragma once

#include <string>
#include <vector>

#include "explore/ranking.h"

namespace vasorod {

/// One line per option in the given order, after a line of names: rank, option, the listed `keys`,
/// fidelity, ending, status, in_range, mark, score, every ranking criterion, past (criteria past
/// their thresholds), seconds, folder, sentence. Comma-separated as RFC 4180 says; what is not
/// known is empty.
std::string options_csv(const std::vector<RankedRow>& rows, const std::vector<std::string>& keys);

}  // namespace vasorod
