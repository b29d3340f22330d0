// Opens a path of edges as a slit.
#pragma once

#include <vector>

#include "geometry/surface_editor.h"

namespace vasorod {

struct Slit {
  std::vector<int>
      rim;  ///< the new boundary loop (the surface on its left): from the path's first vertex
            ///< along the path to its last, and back along the other bank; the editor's vertices
  int other_tip = 0;  ///< index into `rim` of the path's last vertex
};

/// Doubles the path's inner vertices; its tips stay shared. The path has n >= 2 edges, lies inside
/// the surface and does not touch itself. The Euler number drops by 1 and one boundary loop of 2 n
/// edges appears.
Slit open_slit(SurfaceEditor& editor, const std::vector<int>& path);

}  // namespace vasorod
