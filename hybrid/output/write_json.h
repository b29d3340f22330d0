// A result as the text of result.json (interface.md, "Result folder").
#pragma once

#include <string>

#include "output/result.h"

namespace vasorod {

/// Every key of the contract in its order, and what result.h knows beyond it. Numbers read back to the same
/// double; what is not finite is null. Ends with a line feed.
std::string to_json(const Result& result);

}  // namespace vasorod
