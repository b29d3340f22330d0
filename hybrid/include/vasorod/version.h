// The version of the library.
#pragma once

#include <string>

namespace vasorod {

/// The library's version, for example "0.2.0".
std::string version();

}  // namespace vasorod
