// The `coupled` fidelity's problem as data: walls that carry their whole energy, what holds and loads them,
// seams and contacts between them, where the rods say to start; and what comes of it. One minimum of
// everything.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "surface/paper_problem.h"
#include "wall/held_section.h"
#include "wall/wall_energy.h"

namespace vasorod {

/// A deformable body's wall beside its SurfaceBody. Units as there.
struct CoupledVessel {
  WallInput wall;  ///< its `rest` is the body's; `glued` is filled from the rigid sections
  std::vector<HeldSection> sections;
};

/// Where a body's rod carries it at one time of the path.
struct CarriedBody {
  Points points;                ///< p'; empty: at rest
  std::vector<Mat3> rotations;  ///< per vertex, from rest; empty: identity
  std::vector<Pose> sections;   ///< per section: rotation from rest, position of its point; empty: at rest
};

struct CoupledProblem {
  /// Bodies (their k only scales units and contact), seams, pairs that may touch. `fixed` is unused.
  PaperProblem surfaces;
  std::vector<std::unique_ptr<CoupledVessel>> vessels;  ///< per body; none for an obstacle
  /// Carried bodies at time t of the motions and loads, in (0, 1].
  std::function<std::vector<CarriedBody>(double t)> carried;
};

struct CoupledOptions {
  double tolerance = 1e-9;           ///< CoupledMinimiserOptions::tolerance
  double balance_tolerance = 5e-7;   ///< on each body's |sum of forces| / its largest resultant
  double seam_tolerance = 1e-4;      ///< largest seam gap over the mouth's radius
  double tie_tolerance = 1e-9;       ///< misfit of a soft section: length over its radius, radians
  double contact_tolerance = 1e-3;   ///< penetration over the mean edge
  double pressure_tolerance = 1e-4;  ///< change of contact pressures by the last update, mean over mean
  double moment_tolerance = 1e-8;    ///< change of a turning load's moment over the largest moment
  double seam_stiffness = 100;       ///< k_j over the largest k_b, k_s of the joined bodies
  double tie_stiffness = 100;        ///< of a soft section, over the body's k_s
  double contact_stiffness = 10;     ///< penalty times vertex area over k_b + k_s of the softer body
  /// Times at which the path is followed; the last is 1. From 0.7 of the Brazier curvature on a smooth and a
  /// kinked minimum coexist: small steps stay on the branch that leads from rest.
  std::vector<double> times{1};
  bool certify = true;                                   ///< sign of the smallest curvature; saddles are left
  int max_outer = 100;                                   ///< multiplier updates per time
  int max_iterations = 3000, max_factorisations = 60;    ///< per minimisation
  double time_limit = 0;                                 ///< seconds; 0: none
  std::function<bool(const PaperProgress&)> keep_going;  ///< false interrupts; may be empty
};

enum class CoupledStatus {
  converged,
  equilibrium_only,  ///< in equilibrium under a dead moment that has no energy
  unstable,          ///< in equilibrium, with a direction of negative curvature that could not be left
  buckled,           ///< the branch from rest lost its stability on the way; this is the minimum below it
  not_unique,        ///< in equilibrium, with a direction that costs nothing
  iteration_limit,
  interrupted
};
std::string to_string(CoupledStatus);

/// One section of the solved wall. Force and moment are what it does to the wall, the moment about its point.
struct SectionSolution {
  std::string label;
  Vec3 force = Vec3::Zero(), moment = Vec3::Zero(), center = Vec3::Zero();
  Mat3 rotation = Mat3::Identity();  ///< from rest
  Vec3 load = Vec3::Zero();          ///< of the force, what is a dead load
};

struct CoupledSolution {
  CoupledStatus status = CoupledStatus::iteration_limit;
  PaperSolution surface;  ///< positions, pressures, contacts, seam, sums of forces; its binding is zero
  std::vector<std::vector<SectionSolution>> sections;  ///< per body
  double membrane_energy = 0, bending_energy = 0;      ///< bending with what couples it to the membrane
  bool smallest_curvature_positive = false;
  int rest_iterations = 0;
  double reached = 0;  ///< time of the path at which `surface` is
  std::vector<std::string> notes;
};

/// Keeps energies, analyses and factors between solves of one problem.
class CoupledSolver {
 public:
  /// Throws InputError: what is wrong with a wall or its sections, or which rigid motion nothing stops.
  explicit CoupledSolver(CoupledProblem problem, const CoupledOptions& options = {});
  ~CoupledSolver();

  CoupledSolution solve();

  /// Another motion, load or start for the same bodies: `sections` replace the motions and loads of the
  /// body's.
  void set_sections(int body, const std::vector<HeldSection>& sections);
  void set_carried(std::function<std::vector<CarriedBody>(double)> carried);
  /// Another material for one body.
  void set_material(int body, const WallMaterial& material);
  CoupledOptions& options();

 private:
  class Data;
  std::unique_ptr<Data> data_;
};

}  // namespace vasorod
