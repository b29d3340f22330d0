// The bodies of a CoupledProblem that are moved, joined or touched, as one CoupledSystem. The
// system is built again when another body is touched. Scaled units (bodies/scaled_bodies.h).
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "bodies/body_contacts.h"
#include "coupled/coupled_minimiser.h"
#include "coupled/coupled_problem.h"

namespace vasorod {

/// What a patch holds (CoupledStack::narrow()), by ways along edges.
enum class Patch {
  seam,               ///< what is within a radius of the mouth from the seam
  seam_and_contacts,  ///< within two, also from contacts that press or that the start expects
};

/// The problem in scaled units with its system, minimiser and contacts.
class CoupledStack {
 public:
  /// Throws InputError (one sentence) when a wall or its sections are invalid, or when nothing
  /// stops a rigid motion.
  CoupledStack(CoupledProblem problem, const CoupledOptions& options);
  CoupledStack(const CoupledStack&) = delete;  // the contacts refer to the problem
  CoupledStack& operator=(const CoupledStack&) = delete;

  /// As those of CoupledSolver.
  void prepare(const std::function<bool()>& abandoned);
  void set_start(CoupledStart start);
  /// The work of a solve begins with that of what prepare() built for it. Without a start, the
  /// bodies that were only expected to be touched are left to be found.
  void begin_solve();

  /// Builds the system of the modelled bodies, at rest, and with it `first`, `first_wall` and `z`.
  void build();

  /// Replaces the system by that of a patch: all else is held as it is. False: the patch would not
  /// be much smaller.
  bool narrow(Patch patch);
  /// Whether the system is that of a patch.
  bool is_narrow() const { return wide_.has_value(); }
  /// Replaces it by the whole again, whose z is that of before narrow().
  void widen();
  /// Forgets contacts and multipliers: the walls can begin once more.
  void begin_again();
  /// CoupledOptions::passes_through of the walls where they are now.
  bool passes_through() const;

  void set_sections(int body, const std::vector<HeldSection>& sections);
  void set_material(int body, const Material& material);
  /// Gives modelled walls the materials with which they go their way (stiffening.h): in a problem
  /// without seams or a start, which have other ways. One that is touched on the way keeps its own.
  void ease();
  /// Whether some are still softer than their own.
  bool is_eased() const;
  /// A step of the eased walls to their own materials, from the minimum z, which is moved towards
  /// the next one.
  void stiffen();
  /// Gives walls that are still eased their own materials; the system is to be built again then.
  void end_easing() noexcept;

  /// Numbers the contacts found last for the system.
  void stack_contacts();
  /// Finds the contacts where the bodies are now, and numbers them.
  void search_contacts();
  /// Sets the bodies' `now` from z.
  void unstack() { unstack(z); }
  /// Finds what touches itself at a point on the way. Returns the smallest gap of a wall from
  /// itself, scaled length; infinite where none are within reach.
  double follow(const Eigen::VectorXd& at);
  /// Whether a shorter step of the path may find what one did not: not where contacts press, or a
  /// wall has touched itself by contacts, as those that find no end find none there either; nor
  /// where the stage is spent.
  bool goes_on_in_shorter_steps() const;
  /// Whether something may have contacts with itself.
  bool feels_itself() const;
  /// Sets the share (0 to 1) of CoupledVessel::inflation; 1 at first.
  void set_inflation(double share);
  /// Whether any of it is in a lumen.
  bool is_inflated() const;
  /// Sets the offsets of the seam to those of a time of its way.
  void set_seam_offsets(double time);
  /// Updates the multipliers of the seam after a minimisation.
  void update_seams();

  /// A state that stays valid when the reference rotations of its rotation vectors change.
  struct Placed {
    Eigen::VectorXd z;
    std::vector<std::vector<SectionPlacement>> placements;  ///< per wall and section
  };
  Placed placed() const;
  void place(const Placed& state);

  bool any_modelled() const;
  /// Whether there is a wall that hides_forces() (stiffening.h).
  bool hides_forces() const;
  /// A sentence for each that rounding hides: loads, forces of a wall.
  std::vector<std::string> hidden_by_rounding() const;
  /// From here on CoupledOptions::most_per_stage are counted anew.
  void begin_stage() { before_stage_ = work.counts.factorisations; }
  /// Whether they are used up.
  bool spent() const;
  /// Scaled length.
  double largest_seam_gap() const;
  /// Smallest RMS radius of the rings of all sections, scaled length.
  double ring_radius() const;
  Points scaled_points(const Points& p) const {
    return (p.rowwise() - scaled.origin.transpose()) / scaled.length;
  }

  CoupledProblem problem;
  CoupledOptions options;
  ScaledBodies scaled;
  std::unique_ptr<BodyContacts> contacts;
  /// Radius of the mouth, scaled length.
  double seam_radius = 0;
  std::unique_ptr<CoupledSystem> system;
  Work work;  ///< of all minimisers of the present solve
  std::unique_ptr<CoupledMinimiser> minimiser;
  StackedContacts stacked;
  /// Per body: its first vertex, and its wall; -1: not modelled.
  std::vector<int> first, first_wall;
  Eigen::VectorXd z;

 private:
  void take_start();
  void expect_pressures();
  std::vector<char> in_patch(size_t body, Patch patch) const;
  std::vector<int> pressed_on(size_t body) const;
  int add_wall(size_t body, const std::vector<HeldSection>& sections, const WallPatch* patch);
  void join();
  void expect_touched();
  void take_part(size_t body, bool does);
  void place_seams();
  void unstack(const Eigen::VectorXd& at);
  HeldSection scale(const HeldSection& section) const;
  std::vector<HeldSection> scaled_sections(size_t body) const;
  WallInput scaled_wall(size_t body) const;
  WallEnergy& energy_of(size_t body);
  bool hides_forces(size_t body) const;
  bool put_material(size_t body, const Material& material);
  WallLumen lumen_of(size_t body) const;
  void guard_walls();

  std::vector<char> moved_;    // per body: modelled whatever is touched
  std::vector<int> expected_;  // bodies that are modelled by expect_touched() alone
  struct Wide {
    std::unique_ptr<CoupledSystem> system;
    std::unique_ptr<CoupledMinimiser> minimiser;
    Eigen::VectorXd z;
  };
  std::optional<Wide> wide_;   // while the system is that of a patch
  bool starts_later_ = false;  // set_start() will be called, or was
  Counts prepared_;            // of prepare(), for the next solve
  std::vector<std::unique_ptr<WallEnergy>> energies_;
  std::vector<std::shared_ptr<CrossingGuard>> guards_;  // per body
  std::vector<Vec3> seam_multipliers_, seam_offsets_;
  double inflation_ = 1;
  std::vector<std::optional<Material>> own_;  // per body; of eased walls
  long before_stage_ = 0;                     // factorisations
};

}  // namespace vasorod
