// The real vessels outside the source tree (../shared/anatomy), excluded by their licence notice.
// Tests that read them have RealAnatomy in their names. Without the files they are not registered,
// and the configuration says so.
#pragma once

#include <filesystem>

namespace vasorod::testing {

inline std::filesystem::path real_anatomy() {
  return std::filesystem::path(VASOROD_SOURCE_DIR) / ".." / "shared" / "anatomy";
}

}  // namespace vasorod::testing
