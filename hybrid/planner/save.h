// Writes what the user made beside the opened scene, and nothing over a file without being asked.
#pragma once

#include <filesystem>
#include <mutex>
#include <string>

#include "planner/opened_scene.h"
#include "planner/stored_result.h"

namespace vasorod::planner {

/// Held while a file is written, so that the program does not end in the middle of that.
std::mutex& writing();

/// A plain name of letters, digits, `_`, `-` and `.`, at most 100 bytes, that begins with a letter,
/// a digit or `_`. Throws Refusal (400).
void check_name(const std::string& name, const std::string& ending);

/// Writes the scene with the plan to `folder`/`name`; {file, note}. Throws Refusal (409 where the
/// file is there and may not be overwritten), FileError, InputError.
Json save_scene(const OpenedScene& opened, const Plan& plan, const std::string& fidelity,
                const std::string& name, bool overwrite);

/// Writes a result folder with its report to `folder`/`name`; {folder}. Throws Refusal (409),
/// FileError.
Json keep_result(const StoredResult& stored, const std::filesystem::path& folder,
                 const std::string& name);

}  // namespace vasorod::planner
