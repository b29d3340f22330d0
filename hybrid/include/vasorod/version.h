// Which version of the library this is.
#pragma once

#include <string>

namespace vasorod {

/// For example "0.1.0".
std::string version();

}  // namespace vasorod
