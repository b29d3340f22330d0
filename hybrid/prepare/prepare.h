// Makes a vessel surface of what a segmentation leaves.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <vasorod/types.h>

#include "prepare/repair.h"

namespace vasorod {

/// What to prepare.
struct PrepareRequest {
  /// One mask (NIfTI, NRRD or MetaImage), or surfaces (VTP, STL, PLY or OBJ) that are parts of one
  /// vessel.
  std::vector<std::filesystem::path> files;
  std::optional<int> label;               ///< of a mask; empty: its only one
  std::optional<std::string> units;       ///< mm, cm or m; empty: the file's, or guessed
  std::optional<std::string> from_space;  ///< LPS or RAS where the file does not say
  std::optional<std::string> space;       ///< LPS or RAS to convert to; empty: the file's
  std::vector<Vec3> ends;  ///< places of the ends to open, mm, output space; empty: all found
  double cut_branches_below = 0;  ///< radius of the branches to take off, mm
  std::optional<double> remesh;   ///< edge, mm; empty: only where the wall is built anew
  /// Called with one line of text at each step.
  std::function<void(const std::string&)> progress = [](const std::string&) {};
};

/// An open end.
struct PreparedEnd {
  Vec3 center = Vec3::Zero();  ///< mm
  Vec3 normal = Vec3::Zero();  ///< unit, out of the vessel
  double radius = 0;           ///< of the circle of its perimeter, mm
};

/// A vessel surface, in mm: open ends, outward, one part, no handle, no self-intersection.
struct PreparedSurface {
  TriangleSurface surface;        ///< mm
  std::string space;              ///< LPS, RAS or empty: unknown
  std::vector<std::string> done,  ///< what was done, in order
      warnings;                   ///< what a user should look at
  std::vector<PreparedEnd> ends;
  std::vector<LeftOut> left_out;                   ///< parts of the input that are not in it, mm
  double largest_distance = 0, mean_distance = 0;  ///< from its wall to the input's, mm
  double volume_before = 0, volume_after = 0;  ///< mm^3, before and after smoothing, ends closed
  std::string refusal;                         ///< why `fit` does not accept it; empty: it does
};

/// Throws InputError (one sentence with the file) for what cannot become a vessel surface.
PreparedSurface prepare(const PrepareRequest& request);

}  // namespace vasorod
