// The result folder of interface.md: result.json, the vessels, their centerlines and stumps, scene.pvd,
// report.html.
#pragma once

#include <filesystem>

#include "output/result.h"

namespace vasorod {

/// Replaces `folder` whole (output/folder_replacement.h). Sets seconds["write"] and adds it to
/// seconds["total"], so that what is printed afterwards agrees with result.json. Throws FileError; the old
/// folder is then as it was. Throws InputError where two vessels' files would have one name.
void write_result_folder(Result& result, const std::filesystem::path& folder);

}  // namespace vasorod
