// Moves the vertices of a boundary loop along it, and inserts others, so that the loop has given
// vertices.
#pragma once

#include <vector>

#include "geometry/loops.h"
#include "geometry/surface_editor.h"

namespace vasorod {

/// A vertex that a loop is to have.
struct LoopTarget {
  int corner = -1;       ///< index into the loop of the vertex that slides there, -1: a new vertex
  double fraction = 0;   ///< of the loop's length: the place of a vertex that slides
  double between = 0.5;  ///< a new vertex: its share of the way from the target before it to the
                         ///< next target that slides
};

/// The loop with its targets.
struct SlidLoop {
  std::vector<int> vertices;  ///< per target; empty if a slide was refused
  std::vector<int> refused;   ///< targets whose vertices could not get there
};

/// `loop` are vertices of the editor's input in boundary order, `curve` is their polygon, `targets`
/// are in the same or the opposite cyclic order. Vertices slide one after another, each as far as
/// its triangles allow, and triangles beside the loop are flipped, until all have arrived or none
/// can move.
SlidLoop slide_loop(SurfaceEditor& editor, const std::vector<int>& loop, const LoopCurve& curve,
                    const std::vector<LoopTarget>& targets);

}  // namespace vasorod
