// The files of page/, embedded by CMake: report.html needs nothing beside itself.
#pragma once

#include <string_view>

namespace vasorod {

extern const std::string_view report_css, view_js;

}  // namespace vasorod
