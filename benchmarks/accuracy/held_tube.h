// A tube of E = 1 between two rigid sections, solved by the coupled minimum, and measurements in
// its middle.
#pragma once

#include "accuracy/tube_meshes.h"
#include "coupled/coupled_problem.h"
#include "geometry/rigid_motion.h"

namespace vasorod::bench {

/// A tube and its wall.
struct HeldTube {
  TubeSpec shape;  ///< only length, radius and bend_deg are used
  double thickness = 1, poisson = 0.3;
  TubeMesh mesh;
  TriangleSurface rest;

  HeldTube(TubeMesh mesh, double length, double radius, double thickness, double poisson = 0.3,
           double bend_deg = 0);
  double area() const;     ///< of the wall's section
  double inertia() const;  ///< of the wall's section, about a diameter
  double shear_modulus() const { return 1 / (2 * (1 + poisson)); }
};

WallInput wall_of(const HeldTube& tube);
SurfaceBody body_of(const HeldTube& tube);
/// The end at s = 0 or at the length, held at rest.
HeldSection rim(const HeldTube& tube, double s);

/// Whether the solution is converged and certified.
bool settled(const CoupledSolution& solution);

/// A solved tube.
struct HeldAnswer {
  bool settled = false;
  Points positions;
  Vec3 force, moment;  ///< of the end on the wall; moment about the end's centre
};

/// A motion of the end by a constant change of the axis's strain (v, u). Degrees of freedom of the
/// end (x, y, z, rx, ry, rz in its own frame) that are not held are free; `force` loads them.
struct EndMotion {
  Vec6 change = Vec6::Zero();
  std::array<bool, 6> held{true, true, true, true, true, true};
  Vec3 force = Vec3::Zero();
};
HeldAnswer solve(const HeldTube& tube, const EndMotion& end);

/// The section's mean pose: centre, and the rotation from rest that fits its vertices best. On
/// staggered rows, a section is the row nearest to s that starts on the normal; otherwise the
/// vertices within 0.8 spacings.
struct SectionMean {
  double s = 0, radius = 0;  ///< arc length; mean distance from the centre over its rest value
  double flattening = 0, widening = 0;  ///< of the diameters along the normal and the binormal
  Vec3 centre = Vec3::Zero();
  Mat3 rotation = Mat3::Identity();
};
SectionMean section_mean(const HeldTube& tube, const Points& positions, double s);

}  // namespace vasorod::bench
