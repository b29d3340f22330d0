// Fits a centerline and a reference rod to one vessel surface.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include <vasorod/result.h>

namespace vasorod {

/// What to fit.
struct FitRequest {
  std::filesystem::path surface;   ///< surface file: VTP, STL, PLY or OBJ
  std::string length_unit = "mm";  ///< unit of the surface: mm, cm or m
  /// Target edge length of a remeshing before the fit, in the surface's unit; empty: no remeshing.
  std::optional<double> remesh;
};

/// Reads, checks and fits a surface. The result has one vessel at rest: `rest` and `current` are
/// its surface, `centerline` is its rod. Throws InputError (one sentence with the file) if the
/// surface is missing or no open tubular vessel, FileError if the file may not be read.
Result fit(const FitRequest& request);

}  // namespace vasorod
