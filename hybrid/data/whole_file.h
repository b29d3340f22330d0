// Reads a file into memory.
#pragma once

#include <filesystem>
#include <string>

namespace vasorod {

/// All bytes of a file. Throws FileError if it cannot be opened or read.
std::string whole_file(const std::filesystem::path& file);

}  // namespace vasorod
