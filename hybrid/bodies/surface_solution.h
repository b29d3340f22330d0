// What comes of a surface solve, whichever energies it minimised.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include <vasorod/status.h>
#include <vasorod/types.h>

namespace vasorod {

/// Forces are those on the body.
struct BodySolution {
  bool modelled = false;  ///< false: nothing moves, joins or touches it; it is returned at rest
  Points positions;
  Eigen::VectorXd pressure;  ///< contact, stress, per vertex; exactly 0 when apart
  Points support_force;      ///< per vertex: what holds a fixed vertex
  Points binding_force;      ///< per vertex: what the rod does to the surface; the rod feels the opposite
  Vec3 support = Vec3::Zero(), binding = Vec3::Zero(), joining = Vec3::Zero(),
       contact = Vec3::Zero();  ///< sums
  double residual = 0;          ///< |sum of the four| / the largest of them; 0 where all are rounding
  double contact_area = 0, largest_pressure = 0;
};

/// Between bodies a and b as listed in BodyProblem::contacts.
struct ContactSolution {
  int a = 0, b = 0;
  bool within_reach = false;  ///< false: the pair never came near; the numbers below are zero
  Vec3 force = Vec3::Zero();  ///< on a
  double area = 0, largest_pressure = 0;
  int swallowed = 0;      ///< vertices so deep in the other body that contact no longer knows their side:
                          ///< the sections were carried through it, and the pressure is too small
  double held_depth = 0;  ///< how deep rigid ends of the two are held inside each other: no wall can
                          ///< yield there, contact beside them is left out
  double smallest_gap =
      std::numeric_limits<double>::infinity();  ///< between outer walls, counted from rest where they
                                                ///< overlap there; infinite where no walls face
};

struct SurfaceSolution {
  Status status = Status::iteration_limit;
  std::vector<BodySolution> bodies;
  std::vector<ContactSolution> contacts;
  double binding_energy = 0, bending_energy = 0, stretching_energy = 0, joining_energy = 0,
         contact_energy = 0;
  double residual = 0;
  bool smallest_curvature_positive = false;  ///< only where it was asked for
  int iterations = 0, outer_iterations = 0, factorisations = 0;
  double largest_seam_gap = 0, rms_seam_gap = 0, seam_radius = 0;
  std::vector<std::string> notes;  ///< which criterion was not met where there is no equilibrium

  /// One line: status, counts, residual, seam.
  std::string brief_report() const;
};

}  // namespace vasorod
