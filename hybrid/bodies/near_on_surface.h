// Which vertices of a surface are near each other along it, at rest.
#pragma once

#include <vector>

#include <vasorod/types.h>

#include "geometry/edge_paths.h"

namespace vasorod {

/// Vertices within a distance of each other along the edges, found where they are asked for.
class NearOnSurface {
 public:
  /// `limit`: the distance, length.
  NearOnSurface(const TriangleSurface& rest, double limit);

  bool are(int a, int b) const;

 private:
  Points points_;
  double limit_;
  EdgePaths paths_;
  mutable std::vector<std::vector<int>> within_;  // per vertex, sorted; empty: not asked for yet
};

}  // namespace vasorod
