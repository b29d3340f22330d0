// Writes the result folder: result.json, vessels, centerlines, stumps, scene.pvd, pictures and
// report.html.
#pragma once

#include <filesystem>

#include <vasorod/result.h>

namespace vasorod {

/// Writes a result to `folder`. The folder must be absent, empty or an earlier result; it is
/// replaced as a whole by one rename. Sets seconds["write"] and adds it to seconds["total"], so
/// that later output agrees with result.json. Throws FileError if the folder cannot be replaced or
/// written (the old folder is then unchanged), InputError if the files of two vessels would have
/// the same name.
void write_result_folder(Result& result, const std::filesystem::path& folder);

}  // namespace vasorod
