// The real vessels beside the project (../shared/anatomy). Their notice keeps them out of the tree:
// tests that read them carry RealAnatomy in their names and are not registered where they are
// absent, which configuring says.
#pragma once

#include <filesystem>

namespace vasorod::testing {

inline std::filesystem::path real_anatomy() {
  return std::filesystem::path(VASOROD_SOURCE_DIR) / ".." / "shared" / "anatomy";
}

}  // namespace vasorod::testing
