// Reads a file into memory, and writes one whole.
#pragma once

#include <filesystem>
#include <string>

namespace vasorod {

/// All bytes of a file. Throws FileError if it cannot be opened or read.
std::string whole_file(const std::filesystem::path& file);

/// Writes a file whole or not at all: beside its place as .NAME.writing-PROCESS, then renamed. A
/// killed process leaves that. Throws FileError.
void write_whole_file(const std::filesystem::path& file, const std::string& bytes);

/// The same for a file that must not be there yet, also not since it was looked for: false, and
/// nothing is written, where it is.
bool write_new_file(const std::filesystem::path& file, const std::string& bytes);

/// What the names of files that were being written have in them.
inline constexpr const char* half_written_file = ".writing-";

}  // namespace vasorod
