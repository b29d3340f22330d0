// The result folder (docs/result.md): result.json, the vessels, their centerlines and stumps,
// scene.pvd, pictures and report.html.
#pragma once

#include <filesystem>

#include <vasorod/result.h>

namespace vasorod {

/// Writes a result to `folder`, which must be absent, empty or an earlier result: it is replaced
/// whole, by one rename. Sets seconds["write"] and adds it to seconds["total"], so that what is
/// printed afterwards agrees with result.json. Throws FileError where the folder cannot be replaced
/// or written (the old one is then as it was), InputError where two vessels' files would have one
/// name.
void write_result_folder(Result& result, const std::filesystem::path& folder);

}  // namespace vasorod
