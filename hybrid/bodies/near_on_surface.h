// Which vertices of a surface are near each other along it, at rest.
#pragma once

#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

#include <vasorod/types.h>

namespace vasorod {

/// Vertices within a distance of each other along the edges, found where they are asked for.
class NearOnSurface {
 public:
  /// `limit`: the distance, length.
  NearOnSurface(const TriangleSurface& rest, double limit);

  bool are(int a, int b) const;

 private:
  std::unordered_set<int> around(int source) const;

  Points points_;
  double limit_;
  std::vector<std::vector<std::pair<int, double>>> edges_;  // per vertex: neighbour, length
  mutable std::unordered_map<int, std::unordered_set<int>> within_;
};

}  // namespace vasorod
