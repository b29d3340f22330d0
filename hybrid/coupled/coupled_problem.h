// The problem of the `coupled` fidelity as data: walls with their full elastic energy, their
// supports and loads, seams and contacts between them, and start positions given by the rods; and
// its solution, one minimum of the total energy.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "bodies/body_problem.h"
#include "bodies/seam_way.h"
#include "bodies/surface_options.h"
#include "bodies/surface_solution.h"
#include "coupled/held_section.h"
#include "coupled/roughness.h"
#include "wall/wall_energy.h"

namespace vasorod {

/// The wall of a deformable body, in addition to its SurfaceBody. Units as there.
struct CoupledVessel {
  WallInput wall;  ///< its `rest` is the body's; `glued` is filled from the rigid sections
  std::vector<HeldSection> sections;
  /// At rest `scan`, which the prestress of `wall` should balance; at the end of the path `after`.
  std::optional<LumenPressure> pressure;
  /// Added to it, so that walls that would fold stay round; 0 or more, stress. It stays there to
  /// the end unless CoupledProblem::lets_out.
  double inflation = 0;
};

/// Where walls are expected at the end of the path, as coarser ones or an earlier solve found them.
struct CoupledStart {
  std::vector<CarriedBody> bodies;        ///< at time 1; one without points is not touched
  std::vector<Eigen::VectorXd> pressure;  ///< per body, of contacts on its vertices, stress
  /// CoupledMinimiserOptions::start of the first minimisation to the minimum, and of that of the
  /// first step that brings walls apart.
  Roughness roughness = Roughness::rough;
  bool buckled = false;  ///< the smooth branch from rest lost its stability before
};

/// Input of CoupledSolver.
struct CoupledProblem {
  /// Bodies (their k only sets the scale of units and contact), seams, and pairs that may touch.
  /// `fixed` is not used.
  BodyProblem surfaces;
  /// Per body; null for an obstacle.
  std::vector<std::unique_ptr<CoupledVessel>> vessels;
  /// Positions of the bodies given by the rods at time t of the motions and loads, in (0, 1].
  std::function<std::vector<CarriedBody>(double t)> carried;
  /// How the seam is brought together; empty: its start is closed.
  std::optional<SeamWay> seam_way;
  /// Joined walls touch right up to their seam from the beginning; what lies in each other in the
  /// start is brought apart (seam_closing.h).
  bool meet_up_to_seams = false;
  /// Walls whose start is inflated are let out in steps before the last minimum (seam_closing.h).
  /// Needs `start`.
  bool lets_out = false;
  /// What touches itself is kept apart by a barrier (crossing_guard.h) and not by contacts: where
  /// walls crumple, these are found differently without end. The walls must not start through
  /// themselves.
  bool guarded = false;
  static constexpr double guard_reach = 0.1;  ///< of the barrier, mean edges
  /// Empty: the walls start where the rods carry them.
  std::optional<CoupledStart> start;
};

struct CoupledSolution;

/// Options of the `coupled` solve. `tolerance`: CoupledMinimiserOptions::tolerance.
/// `contact_stiffness` and `seam_stiffness` are larger than in `paper`, because the true Hessian
/// tolerates them.
struct CoupledOptions : SurfaceOptions {
  CoupledOptions();

  /// On the misfit of a soft section: length over its radius, radians.
  double tie_tolerance = 1e-9;
  /// On the change of the moment of a turning load over the largest moment.
  double moment_tolerance = 1e-8;
  /// Of a soft section, over k_s of the body.
  double tie_stiffness = 100;
  /// Multiplier updates after which walls that press on each other stick between searches
  /// (contact_pair.h): where walls crumple, contacts are found differently each time without end.
  /// After twice as many, they are searched at a tenth of the updates only, later at fewer
  /// (late_contacts.h). 0: never.
  int hold_after = 0;
  /// After so many factorisations the solve ends without a minimum, at its next multiplier update;
  /// of walls that are let out each stage may take as many: to part them, to let them out, and to
  /// find the minimum. 0: no limit.
  int most_per_stage = 0;
  /// Times at which the path is solved; the last is 1. From 0.7 of the Brazier curvature on, a
  /// smooth and a kinked minimum coexist; small steps stay on the branch that starts at rest.
  std::vector<double> times{1};
  /// CoupledMinimiserOptions::start of the first minimisation, where no CoupledProblem::start is
  /// given.
  Roughness start = Roughness::near;
  /// Called with the state so far (status interrupted) before an ordering or a factorisation, at
  /// most once a second and for a hundredth of the time. May be empty.
  std::function<void(CoupledSolution&&)> keep;
  /// Whether walls at these positions, n x 3 per body, length, pass through each other: asked of
  /// the first minimum found from a CoupledProblem::start that is not near it and, of a smooth one,
  /// before that when its seam and contacts have come to rest (smooth_start.h). Where it is true,
  /// joined walls touch right up to their seam from there on, and what lies in each other is
  /// brought apart; where that fails they go on as they are. May be empty: they do not.
  std::function<bool(const std::vector<Points>& now)> passes_through;

  /// Empty when the options are valid, else one sentence that names the invalid option.
  std::optional<std::string> is_invalid() const;
};

/// One section of the solved wall. Force and moment act from the section on the wall; the moment is
/// about the section's point.
struct SectionSolution {
  std::string label;
  Vec3 force = Vec3::Zero(), moment = Vec3::Zero(), center = Vec3::Zero();
  Mat3 rotation = Mat3::Identity();  ///< from rest
  Vec3 load = Vec3::Zero();          ///< part of the force that is a dead load
};

/// Result of CoupledSolver::solve(), in the problem's units.
struct CoupledSolution {
  Status status = Status::iteration_limit;
  /// Positions, pressures, contacts, seam, sums of forces; its binding is zero.
  SurfaceSolution surface;
  std::vector<std::vector<SectionSolution>> sections;  ///< per body
  std::vector<FaceExtremes> faces;                     ///< per body; of an obstacle: at rest
  /// Strain energy, a prestress' included. The bending energy includes its coupling with the
  /// membrane.
  double membrane_energy = 0, bending_energy = 0;
  bool smallest_curvature_positive = false;
  int rest_iterations = 0;
  /// Time of the path reached by `surface`.
  double reached = 0;
  std::vector<std::string> notes;

  /// One line: status, counts, residual, seam.
  std::string brief_report() const;
};

/// Solves one problem repeatedly; energies, symbolic analyses and factors are kept between solves.
class CoupledSolver {
 public:
  /// Throws InputError (one sentence) when an option, a wall or its sections are invalid, or when
  /// nothing stops a rigid motion.
  explicit CoupledSolver(CoupledProblem problem, const CoupledOptions& options = {});
  ~CoupledSolver();

  CoupledSolution solve();

  /// Builds what solve() needs first and finds the order of elimination, before the start is known:
  /// with the bodies on which others press where their rods carry them. `abandoned` is asked on the
  /// way; where it says so, the rest is left to solve().
  void prepare(const std::function<bool()>& abandoned);
  /// Replaces CoupledProblem::start. What prepare() has built is built again by solve() where the
  /// start touched other bodies; the result is the same. Throws InputError where nothing stops a
  /// touched body, and must not solve then.
  void set_start(CoupledStart start);

  /// Replaces the motions and loads of the body's sections.
  void set_sections(int body, const std::vector<HeldSection>& sections);
  /// Replaces CoupledProblem::carried.
  void set_carried(std::function<std::vector<CarriedBody>(double)> carried);
  /// Replaces the material of one body.
  void set_material(int body, const Material& material);
  CoupledOptions& options();

 private:
  class Data;
  std::unique_ptr<Data> data_;
};

}  // namespace vasorod
