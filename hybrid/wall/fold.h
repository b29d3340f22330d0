// The sharpest fold of a triangle surface.
#pragma once

#include "geometry/types.h"

namespace vasorod {

struct Fold {
  double cosine = 1;  ///< of the angle between the outward normals on both sides of an edge; -1: folded flat
  Vec3 place = Vec3::Zero();
};

/// Triangles without area are passed over.
Fold sharpest_fold(const TriangleSurface& surface);

}  // namespace vasorod
