// The `coupled` fidelity's problem as data: walls that carry their whole energy, what holds and
// loads them, seams and contacts between them, where the rods say to start; and what comes of it.
// One minimum of everything.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "bodies/body_problem.h"
#include "bodies/surface_options.h"
#include "bodies/surface_solution.h"
#include "coupled/held_section.h"
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
  std::vector<Pose>
      sections;  ///< per section: rotation from rest, position of its point; empty: at rest
};

struct CoupledProblem {
  /// Bodies (their k only scales units and contact), seams, pairs that may touch. `fixed` is
  /// unused.
  BodyProblem surfaces;
  std::vector<std::unique_ptr<CoupledVessel>> vessels;  ///< per body; none for an obstacle
  /// Carried bodies at time t of the motions and loads, in (0, 1].
  std::function<std::vector<CarriedBody>(double t)> carried;
};

/// `tolerance`: CoupledMinimiserOptions::tolerance. `contact_stiffness`, `seam_stiffness`: larger
/// than in `paper`, as the true Hessian bears them.
struct CoupledOptions : SurfaceOptions {
  CoupledOptions();

  double tie_tolerance = 1e-9;     ///< misfit of a soft section: length over its radius, radians
  double moment_tolerance = 1e-8;  ///< change of a turning load's moment over the largest moment
  double tie_stiffness = 100;      ///< of a soft section, over the body's k_s
  /// Times at which the path is followed; the last is 1. From 0.7 of the Brazier curvature on a
  /// smooth and a kinked minimum coexist: small steps stay on the branch that leads from rest.
  std::vector<double> times{1};

  std::optional<std::string> is_invalid() const;
};

/// One section of the solved wall. Force and moment are what it does to the wall, the moment about
/// its point.
struct SectionSolution {
  std::string label;
  Vec3 force = Vec3::Zero(), moment = Vec3::Zero(), center = Vec3::Zero();
  Mat3 rotation = Mat3::Identity();  ///< from rest
  Vec3 load = Vec3::Zero();          ///< of the force, what is a dead load
};

struct CoupledSolution {
  Status status = Status::iteration_limit;
  SurfaceSolution
      surface;  ///< positions, pressures, contacts, seam, sums of forces; its binding is zero
  std::vector<std::vector<SectionSolution>> sections;  ///< per body
  double membrane_energy = 0, bending_energy = 0;  ///< bending with what couples it to the membrane
  bool smallest_curvature_positive = false;
  int rest_iterations = 0;
  double reached = 0;  ///< time of the path at which `surface` is
  std::vector<std::string> notes;

  /// One line: status, counts, residual, seam.
  std::string brief_report() const;
};

/// Keeps energies, analyses and factors between solves of one problem.
class CoupledSolver {
 public:
  /// Throws InputError: what is wrong with an option, a wall or its sections, or which rigid motion
  /// nothing stops.
  explicit CoupledSolver(CoupledProblem problem, const CoupledOptions& options = {});
  ~CoupledSolver();

  CoupledSolution solve();

  /// Another motion, load or start for the same bodies: `sections` replace the motions and loads of
  /// the body's.
  void set_sections(int body, const std::vector<HeldSection>& sections);
  void set_carried(std::function<std::vector<CarriedBody>(double)> carried);
  /// Another material for one body.
  void set_material(int body, const Material& material);
  CoupledOptions& options();

 private:
  class Data;
  std::unique_ptr<Data> data_;
};

}  // namespace vasorod
