// Opens a path of mesh edges as a slit.
#pragma once

#include <vector>

#include "geometry/surface_editor.h"

namespace vasorod {

/// An opened slit.
struct Slit {
  /// The new boundary loop, the surface on its left, vertices of the editor: from the path's first
  /// vertex along the path to its last, and back along the other bank.
  std::vector<int> rim;
  int other_tip = 0;  ///< index into `rim` of the path's last vertex
};

/// Duplicates the path's inner vertices; the tips stay shared. The path has n >= 2 edges, lies
/// inside the surface and does not touch itself. The Euler number decreases by 1, and there is one
/// new boundary loop of 2 n edges.
Slit open_slit(SurfaceEditor& editor, const std::vector<int>& path);

}  // namespace vasorod
