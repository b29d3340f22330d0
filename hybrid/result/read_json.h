// result.json read back, as far as a comparison of two results needs it.
#pragma once

#include <filesystem>

#include <vasorod/result.h>

namespace vasorod {

/// Reads scene, program, fidelity, status, units, ends, seconds, inputs and the vessels' names (no
/// geometry). A null number becomes NaN. Throws InputError, one sentence, where the file is missing
/// or not a result of ours, or a surface or centerline that it lists is not beside it.
Result read_json(const std::filesystem::path& file);

/// Whether a folder holds a result.json that one of our programs wrote.
bool holds_our_result(const std::filesystem::path& folder);

}  // namespace vasorod
