// The bodies of a BodyProblem in the solver's own units: lengths in mean edges about the bodies'
// centre, stiffnesses in units of the largest coefficient. Results in mm or m, Pa or MPa then agree
// to the last digits.
#pragma once

#include "bodies/body_problem.h"
#include "bodies/crossing_guard.h"

namespace vasorod {

/// One body in scaled units; fields as in SurfaceBody.
struct ScaledBody {
  TriangleSurface rest;
  /// p' [6], the same at the present time of a path, and the present positions.
  Points carried, placed, now;
  std::vector<Mat3> rotations;
  std::vector<char> fixed;
  Coefficients k;
  double thickness = 0, offset = 0;
  double mean_edge = 0, mean_area = 0;  ///< mean_area: per vertex
  bool obstacle = false;
  bool moved = false;     ///< its rod has moved from rest
  bool modelled = false;  ///< among the unknowns
};

/// The faces of a body's wall for a guard (crossing_guard.h), scaled length.
GuardedWall guarded_wall(const ScaledBody& body);

/// All bodies in scaled units, and the units.
struct ScaledBodies {
  double length = 1;     ///< one scaled unit in the problem's length unit
  double stiffness = 1;  ///< force / length
  Vec3 origin = Vec3::Zero();
  std::vector<ScaledBody> bodies;
  double force() const { return stiffness * length; }
  double pressure() const { return stiffness / length; }
  double energy() const { return stiffness * length * length; }
  Points unscaled(const Points& p) const { return (p * length).rowwise() + origin.transpose(); }
};

/// Scales the bodies. Throws InputError (one sentence with the body's name) when array sizes do not
/// match or numbers are out of range.
ScaledBodies scale_bodies(const BodyProblem& problem);

}  // namespace vasorod
