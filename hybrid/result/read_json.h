// Reads the parts of result.json that comparisons and pictures need.
#pragma once

#include <filesystem>

#include <vasorod/result.h>

namespace vasorod {

/// Reads scene, program, fidelity, status, units, ends, seconds, inputs, the vessels of an
/// operation with the ends of its incision, and the vessels' names (no geometry). A null number
/// becomes NaN. Throws InputError (one sentence) if the file is missing or was not written by one
/// of our programs, or if a surface or centerline that it lists is missing.
Result read_json(const std::filesystem::path& file);

/// Whether a folder holds a result.json that one of our programs wrote.
bool holds_our_result(const std::filesystem::path& folder);

}  // namespace vasorod
