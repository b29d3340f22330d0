// The last check of a result: where walls pass through themselves or each other.
#pragma once

#include <array>
#include <vector>

#include <vasorod/types.h>

namespace vasorod {

/// A surface that is checked.
struct CheckedBody {
  const TriangleSurface* rest = nullptr;  ///< at rest, length
  const Points* now = nullptr;            ///< its current vertex positions, n x 3, length
  double radius = 0;                      ///< mean radius, length; 0: an obstacle, not checked
};

/// Vertices of two bodies that lie on each other, {vertex of `a`, vertex of `b`}.
struct CheckedSeam {
  int a = -1, b = -1;                     ///< indices of the bodies; -1: there is no seam
  std::vector<std::array<int, 2>> pairs;  ///< one to one
};

/// Two bodies, or one and itself (a = b), whose walls pass through each other.
struct Crossing {
  int a = 0, b = 0;           ///< indices of the bodies, a <= b
  int pairs = 0;              ///< pairs of triangles that cross
  Vec3 where = Vec3::Zero();  ///< the vertex that lies deepest on the wrong side, length
  double depth = 0;           ///< from there to the next wall, length
};

/// All crossings of the bodies, sorted by a, then b; the walls of a seam count as one surface.
/// First the triangles that cross, of bodies of which one at least is not where it was at rest
/// (geometry/crossing_triangles.h). Where there are any, a vertex lies too
/// deep if the space just outside its wall is inside a vessel, by the winding number, and the next
/// wall is further away than e^2 / 4 R + `tolerance` e (e: mean edge, R: mean radius of its body).
/// That is twice the height of a chord of length e: flat triangles cut so far into each other where
/// round walls only touch. What lies inside another body at rest, as scanned, counts where it lies
/// deeper now. Obstacles are checked against vessels only. Bodies with a position that is not
/// finite are left out.
std::vector<Crossing> crossings(const std::vector<CheckedBody>& bodies, const CheckedSeam& seam,
                                double tolerance = 1e-3);

}  // namespace vasorod
