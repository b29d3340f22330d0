// The bundled infant vessels.
#pragma once

#include <filesystem>
#include <string>

#include "surface_file/read_surface.h"

namespace vasorod::testing {

inline std::filesystem::path infant_file(const std::string& name) {
  return std::filesystem::path(VASOROD_SOURCE_DIR) / "meshes" / "infant" / (name + ".vtp");
}

inline TriangleSurface infant(const std::string& name) {
  VesselSpec spec;
  spec.name = name;
  spec.surface = infant_file(name);
  return load_surface(spec, Scene{}).surface;
}

}  // namespace vasorod::testing
