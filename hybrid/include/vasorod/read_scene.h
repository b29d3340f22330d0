// Scene files (docs/scene.md): YAML in, a checked scene out.
#pragma once

#include <filesystem>

#include <vasorod/scene.h>

namespace vasorod {

struct ReadOptions {
  /// True in the finite-element reference only: the hybrid model knows no lumen pressure.
  bool accept_pressure = false;
};

/// Reads and checks a scene file. Throws InputError ("FILE:LINE: KEY: found ..., expected ...").
Scene read_scene(const std::filesystem::path& file, const ReadOptions& options = {});

}  // namespace vasorod
