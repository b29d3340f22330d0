// Fingerprints of input files for result.json, and of texts.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace vasorod {

/// SHA-256 of a file's bytes: 64 hexadecimal digits. Throws InputError if the file cannot be read.
std::string sha256_of_file(const std::filesystem::path& file);

/// SHA-256 of the text's bytes.
std::string sha256_of_text(std::string_view text);

}  // namespace vasorod
