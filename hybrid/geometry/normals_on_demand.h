// Angle-weighted normals of single vertices, for surfaces that move and of which few vertices are
// asked for: those of the whole surface cost more than all else that is done with these few.
#pragma once

#include <vector>

#include "geometry/closest_point.h"

namespace vasorod {

/// The normals of a surface that does not move meanwhile, each computed once. Not thread-safe.
class NormalsOnDemand {
 public:
  /// `surface` must outlive this.
  explicit NormalsOnDemand(const ClosestPoint& surface);

  /// That vertex's row of vertex_normals(), bit for bit.
  Vec3 operator()(int vertex);

 private:
  const ClosestPoint& surface_;
  Points normals_;
  std::vector<char> known_;
};

}  // namespace vasorod
