// The `paper` fidelity's surface problem as data: bodies carried by their rods, seams between them, and what
// comes of it.
#pragma once

#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "geometry/types.h"
#include "surface/coefficients.h"

namespace vasorod {

/// One vessel's surface with what its solved rod says. Sizes: one entry per vertex.
struct SurfaceBody {
  std::string name;
  TriangleSurface rest;         ///< after surgery, rest configuration
  Points carried;               ///< p' [6]; empty: the body's rod has not moved
  std::vector<Mat3> rotations;  ///< R of [8]; empty: identity
  PaperCoefficients k;          ///< unused for an obstacle
  std::vector<char> fixed;      ///< vertices of rigid ends, kept at p'; empty: none
  double thickness = 0;         ///< t, length
  double offset = 0;      ///< from the given surface to the wall's outer face: 0 outer, t/2 mid, t inner
  bool obstacle = false;  ///< never moves, only touched
};

/// Two vertices that a seam joins.
struct SeamPair {
  int body_a = 0, vertex_a = 0;
  int body_b = 0, vertex_b = 0;
};

struct PaperProblem {
  std::vector<SurfaceBody> bodies;
  std::vector<SeamPair> seams;
  std::vector<std::pair<int, int>> contacts;  ///< pairs of bodies that may touch
};

struct PaperProgress {
  int outer = 0, iterations = 0;
  double residual = 0;
};

struct PaperOptions {
  double tolerance = 1e-8;          ///< on |sum of forces| / sum over the terms of |their forces|
  double balance_tolerance = 5e-7;  ///< on each body's |sum of forces| / its largest resultant
  double seam_tolerance = 1e-3;     ///< largest seam gap over the mouth's radius
  double contact_tolerance = 1e-3;  ///< penetration over the mean edge
  double pressure_tolerance =
      3e-3;                     ///< change of the pressures by the last multiplier update, mean over mean
  double seam_stiffness = 100;  ///< k_j over the largest k_b, k_s of the joined bodies: stiff enough to close
                                ///< in two or three updates, soft enough for the preconditioner
  double contact_stiffness = 2;  ///< penalty times vertex area over k_b + k_s of the softer body
  int max_iterations = 3000;     ///< per minimisation between multiplier updates
  int patience = 100;   ///< iterations for a tenfold smaller residual before the true Hessian is tried
  int max_outer = 100;  ///< multiplier updates
  int max_factorisations = 40;  ///< of the true Hessian, per minimisation; 0: never
  bool certify = false;         ///< ask for the sign of the Hessian's smallest curvature at the end
  double time_limit = 0;        ///< seconds; 0: none
  std::function<bool(const PaperProgress&)> keep_going;  ///< false interrupts; may be empty
};

enum class PaperStatus {
  converged,
  unstable,         ///< in equilibrium, but a direction of negative curvature is left (only with `certify`)
  iteration_limit,  ///< best state found; residual, gaps and balance say how good
  interrupted       ///< by keep_going or the time limit
};
std::string to_string(PaperStatus);

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

/// Between bodies a and b as listed in PaperProblem::contacts.
struct ContactSolution {
  int a = 0, b = 0;
  bool within_reach = false;  ///< false: the pair never came near; the numbers below are zero
  Vec3 force = Vec3::Zero();  ///< on a
  double area = 0, largest_pressure = 0;
  int swallowed = 0;      ///< vertices so deep in the other body that contact no longer knows their side: the
                          ///< sections were carried through it, and the pressure is too small
  double held_depth = 0;  ///< how deep rigid ends of the two are held inside each other: no wall can yield
                          ///< there, contact beside them is left out
  double smallest_gap =
      std::numeric_limits<double>::infinity();  ///< between outer walls, counted from rest where they
                                                ///< overlap there; infinite where no walls face
};

struct PaperSolution {
  PaperStatus status = PaperStatus::iteration_limit;
  std::vector<BodySolution> bodies;
  std::vector<ContactSolution> contacts;
  double binding_energy = 0, bending_energy = 0, stretching_energy = 0, joining_energy = 0,
         contact_energy = 0;
  double residual = 0;
  bool smallest_curvature_positive = false;  ///< only with `certify`
  int iterations = 0, outer_iterations = 0, factorisations = 0;
  double largest_seam_gap = 0, rms_seam_gap = 0, seam_radius = 0;
};

/// All pairs of bodies of which at least one is no obstacle.
std::vector<std::pair<int, int>> all_contacts(const std::vector<SurfaceBody>& bodies);

}  // namespace vasorod
