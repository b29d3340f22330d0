// Where a surface goes when a coarser mesh of the same shape has moved.
#pragma once

#include <vector>

#include <vasorod/types.h>

namespace vasorod {

/// A surface that has moved, one entry per point.
struct MovedSurface {
  Points points;                ///< n x 3, length
  std::vector<Mat3> rotations;  ///< the rotation in G
  Eigen::VectorXd values;       ///< of the coarse points, interpolated linearly
};

/// Points of `surface` (at rest, n x 3) moved as `coarse` moved to `moved` (one row per point of
/// `coarse`, as many entries in `values`). Each goes with the closest point p of the coarse mesh:
///
/// ```
/// x = sum_i b_i (x_i + (G_i - I) (p - p_i) / 2) + G (rest - p),   G = sum_i b_i G_i
/// ```
///
/// b_i are the barycentric coordinates of p, G_i the deformation gradient at a vertex, the mean of
/// its triangles', which takes unit normals to unit normals. The factor 1/2 makes the move exact
/// where it is quadratic on the coarse mesh, and smoother across its edges than a linear one.
/// Points on a rim go with a triangle on their own side of it, so that the two sides of a slit that
/// is still closed part as those of the coarse mesh.
MovedSurface moved_with(const TriangleSurface& coarse, const Points& moved,
                        const Eigen::VectorXd& values, const TriangleSurface& surface);

}  // namespace vasorod
