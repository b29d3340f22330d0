// The surface of one label of a mask.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "mask/mask.h"

namespace vasorod {

/// The surface midway between the voxels inside and outside of a label: closed, with stairs.
struct MaskSurface {
  TriangleSurface surface;         ///< in the mask's unit and space
  double voxel = 0;                ///< mean spacing, the mask's unit
  int label = 0;                   ///< the one that was taken
  std::vector<std::string> notes;  ///< what a user should know, one phrase each
};

/// Throws InputError (one sentence with `file`) if the label has no voxel, or if none is asked for
/// and the mask has several. The mask's labels are given up.
MaskSurface mask_surface(const std::string& file, Mask mask, std::optional<int> label);

}  // namespace vasorod
