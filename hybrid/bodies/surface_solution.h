// The result of a surface solve, for any of the surface energies. All values in the problem's
// units.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include <vasorod/status.h>
#include <vasorod/types.h>

#include "numerics/work.h"

namespace vasorod {

/// State of one body. Forces are those acting on the body.
struct BodySolution {
  /// False: nothing moves, joins or touches the body; it is returned at rest.
  bool modelled = false;
  Points positions;
  /// Contact pressure per vertex, stress; exactly 0 where the walls are apart.
  Eigen::VectorXd pressure;
  /// Per vertex, n x 3: the force that holds a fixed vertex.
  Points support_force;
  /// Per vertex, n x 3: force of the rod on the surface; the opposite force acts on the rod.
  Points binding_force;
  /// Sums over the body, force.
  Vec3 support = Vec3::Zero(), binding = Vec3::Zero(), joining = Vec3::Zero(),
       contact = Vec3::Zero();
  /// Of the pressure in the lumen on the wall, without the lids over its ends, force.
  Vec3 lumen = Vec3::Zero();
  /// |sum of the five| / the largest of them, in `coupled` also of the forces of sections; 0 where
  /// all are rounding errors.
  double residual = 0;
  double contact_area = 0, largest_pressure = 0;
};

/// Contact between bodies a and b, as listed in BodyProblem::contacts.
struct ContactSolution {
  int a = 0, b = 0;
  /// False: the pair never came within reach, or what a guard keeps apart does not press; the
  /// numbers below but the gap are zero.
  bool within_reach = false;
  Vec3 force = Vec3::Zero();  ///< on a
  double area = 0, largest_pressure = 0;
  /// Vertices so deep in the other body that contact cannot determine their side any more: the
  /// sections were moved through the other body, and the pressure is too small.
  int swallowed = 0;
  /// How deep rigid ends of the two bodies are held inside each other, length. No wall can yield
  /// there, and contact near them is left out.
  double held_depth = 0;
  /// Between outer faces, relative to rest where they overlap at rest, length; infinite where no
  /// walls face each other.
  double smallest_gap = std::numeric_limits<double>::infinity();
};

/// State of all bodies and contacts.
struct SurfaceSolution {
  Status status = Status::iteration_limit;
  std::vector<BodySolution> bodies;
  std::vector<ContactSolution> contacts;
  double binding_energy = 0, bending_energy = 0, stretching_energy = 0, joining_energy = 0,
         contact_energy = 0;
  double residual = 0;
  /// Meaningful only if SurfaceOptions::certify is set.
  bool smallest_curvature_positive = false;
  int iterations = 0, outer_iterations = 0;
  Work work;  ///< Counts::outer is `outer_iterations`
  double largest_seam_gap = 0, rms_seam_gap = 0, seam_radius = 0;
  std::vector<std::string> notes;  ///< which criterion was not met where there is no equilibrium

  /// One line: status, counts, residual, seam.
  std::string brief_report() const;
};

}  // namespace vasorod
