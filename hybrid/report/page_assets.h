// The files of page/, embedded by CMake, so that report.html needs no other file.
#pragma once

#include <string_view>

namespace vasorod {

extern const std::string_view report_css, view_js;

}  // namespace vasorod
