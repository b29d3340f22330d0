// Reads a result folder: result.json and the vessels' files.
#pragma once

#include <filesystem>

#include <vasorod/result.h>

namespace vasorod {

/// What read_json reads, and of every vessel the surface at rest and in the result with its fields,
/// the centerline with its directors and strains, and the stump. Throws InputError (one sentence)
/// where a file is missing or damaged.
Result read_result_folder(const std::filesystem::path& folder);

}  // namespace vasorod
