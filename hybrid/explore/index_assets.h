// The files of page/, embedded by CMake, so that index.html needs no other file.
#pragma once

#include <string_view>

namespace vasorod {

extern const std::string_view index_css, index_js;

}  // namespace vasorod
