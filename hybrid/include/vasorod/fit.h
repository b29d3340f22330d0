// One vessel surface in, its centerline and reference rod out.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include <vasorod/result.h>

namespace vasorod {

struct FitRequest {
  std::filesystem::path surface;   ///< VTP, STL, PLY or OBJ
  std::string length_unit = "mm";  ///< of the surface: mm, cm or m
  std::optional<double> remesh;  ///< target edge, length: remeshed before the fit; absent: as it is
};

/// Reads, checks and fits a surface. The result's one vessel is at rest: `rest` and `current` are
/// its surface, `centerline` its rod. Throws InputError (a sentence with the file) where the
/// surface is not an open tubular vessel, FileError where it cannot be read.
Result fit(const FitRequest& request);

}  // namespace vasorod
