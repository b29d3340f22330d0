// Shortest paths along the edges of a surface.
#pragma once

#include <unordered_map>
#include <utility>
#include <vector>

#include <vasorod/types.h>

namespace vasorod {

/// Shortest paths along the edges of a surface, in the edges' lengths or in their number.
class EdgePaths {
 public:
  enum class Measure { length, edges };
  explicit EdgePaths(const TriangleSurface& surface, Measure measure = Measure::length);

  /// The vertices whose path from the nearest of `sources` is at most `limit`, with the path.
  std::unordered_map<int, double> within(const std::vector<int>& sources, double limit) const;

 private:
  std::vector<std::vector<std::pair<int, double>>> neighbours_;  // per vertex: other end, measure
};

}  // namespace vasorod
