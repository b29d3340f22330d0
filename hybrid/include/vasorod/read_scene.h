// Reads scene files: YAML in, a checked scene out. README.md shows how to solve one.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <vasorod/scene.h>

namespace vasorod {

/// Reads and checks a scene file. Throws InputError ("FILE:LINE: KEY: found ..., expected ..."), a
/// missing file too; FileError if the file cannot be read.
Scene read_scene(const std::filesystem::path& file);

/// The same of the text of a scene file: a scene made in memory. Surfaces are looked for in
/// `folder`. The messages name no file and no line: "KEY: found ..., expected ..."; one about YAML
/// itself begins with "line N: ".
Scene read_scene_text(const std::string& text, const std::filesystem::path& folder = {});

/// The files that a scene comes from: its own and those of its surfaces.
std::vector<std::filesystem::path> input_files(const Scene& scene);

}  // namespace vasorod
