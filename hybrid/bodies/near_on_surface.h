// Which vertices of a surface are near each other along it, at rest.
#pragma once

#include <unordered_map>

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
  mutable std::unordered_map<int, std::unordered_map<int, double>> within_;
};

}  // namespace vasorod
