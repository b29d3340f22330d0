// Regular and irregular triangle meshes of a tube, as (angle, arc length) of their vertices.
#pragma once

#include <string>

#include <vasorod/tube.h>

namespace vasorod::bench {

/// A mesh of the unrolled tube.
struct TubeMesh {
  std::string name;
  Eigen::VectorXd angle, s;  ///< rim vertices have s = 0 and s = length exactly
  Triangles triangles;
  double edge = 0;  ///< the mean spacing around
};

/// Staggered rows. Triangles are near-equilateral, or `aspect` times longer along the axis. The
/// number of strips is even.
TubeMesh structured(double length, double radius, int around, double aspect = 1);

/// As `structured`, with inner vertices shifted by up to a quarter of their spacing in both
/// directions.
TubeMesh shifted(double length, double radius, int around);

/// Random points with a minimum distance, then Delaunay on the unrolled tube.
TubeMesh blue_noise(double length, double radius, int around);

/// The mesh on a tube with a straight or circular axis.
TriangleSurface placed(const TubeMesh& mesh, const TubeSpec& tube);

}  // namespace vasorod::bench
