// The page, embedded by CMake: the program needs no file beside it.
#pragma once

#include <string_view>

namespace vasorod::planner {

/// A file of the page by its name; empty text: there is none.
std::string_view page_file(std::string_view name);

}  // namespace vasorod::planner
