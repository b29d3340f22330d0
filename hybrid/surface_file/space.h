// The coordinate space that 3D Slicer names in the surfaces it writes.
#pragma once

#include <filesystem>
#include <string>

namespace vasorod {

/// "LPS" or "RAS" where `text` is one of them, else nothing.
std::string known_space(const std::string& text);

/// The space that the head of an STL, PLY or OBJ file names as SPACE=LPS or SPACE=RAS; nothing
/// where it names none.
std::string space_in_head(const std::filesystem::path& file);

}  // namespace vasorod
