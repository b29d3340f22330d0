// Unrolls a patch of a surface into the plane: plane coordinates of its vertices in which lengths
// are as nearly as possible those on the surface.
//
// Minimised is the sum over triangles of area |J - R|^2, J the gradient of the plane coordinates
// and R the rotation nearest to J (Liu et al. 2008, "A local/global approach to mesh
// parameterization"). A patch that can be unrolled without stretch, as that of a cylinder, is.
#pragma once

#include <vector>

#include <vasorod/types.h>

namespace vasorod {

/// What to unroll.
struct ChartRequest {
  std::vector<int> patch;  ///< rows of the surface's triangles; connected, without a full turn
  /// Per entry of `patch` a direction, which need not lie in the triangle: in the mean, the plane's
  /// x axis points there.
  Points along;
  int triangle = 0;                            ///< triangle of the plane's origin
  Vec3 barycentric = Vec3::Constant(1.0 / 3);  ///< barycentric coordinates of the origin
};

/// x and y (length unit) per vertex of the surface, seen from outside; NaN off the patch.
Eigen::MatrixX2d unroll(const TriangleSurface& surface, const ChartRequest& request);

}  // namespace vasorod
