// The version of the library.
#pragma once

#include <string>

namespace vasorod {

/// The library's version, for example "0.1.0".
std::string version();

}  // namespace vasorod
