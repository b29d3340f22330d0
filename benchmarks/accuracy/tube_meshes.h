// Triangle meshes of a tube, regular and not, as (angle, arc length) of their vertices.
#pragma once

#include <string>

#include <vasorod/tube.h>

namespace vasorod::bench {

struct TubeMesh {
  std::string name;
  Eigen::VectorXd angle, s;  ///< rim vertices have s = 0 and s = length exactly
  Triangles triangles;
  double edge = 0;  ///< the mean spacing around
};

/// Staggered rows, triangles near-equilateral or `aspect` times longer along the axis; an even
/// number of strips.
TubeMesh structured(double length, double radius, int around, double aspect = 1);

/// The same with inner vertices shifted by up to a quarter of their spacing, both ways.
TubeMesh shifted(double length, double radius, int around);

/// Points thrown at random with a least distance, then Delaunay on the unrolled tube.
TubeMesh blue_noise(double length, double radius, int around);

/// The mesh on a tube whose axis is straight or circular.
TriangleSurface placed(const TubeMesh& mesh, const TubeSpec& tube);

}  // namespace vasorod::bench
