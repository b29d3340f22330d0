// Fingerprints of input files for result.json.
#pragma once

#include <filesystem>
#include <string>

namespace vasorod {

/// SHA-256 of a file's bytes: 64 hexadecimal digits. Throws InputError if the file cannot be read.
std::string sha256_of_file(const std::filesystem::path& file);

}  // namespace vasorod
