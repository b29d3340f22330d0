// The bodies of a CoupledProblem that something moves, joins or touches as one CoupledSystem:
// built, and built anew when another body is touched. Scaled units (bodies/scaled_bodies.h).
#pragma once

#include <memory>
#include <vector>

#include "bodies/body_contacts.h"
#include "coupled/coupled_minimiser.h"
#include "coupled/coupled_problem.h"

namespace vasorod {

class CoupledStack {
 public:
  /// Throws InputError: what is wrong with a wall or its sections, or which rigid motion nothing
  /// stops.
  CoupledStack(CoupledProblem problem, const CoupledOptions& options);
  CoupledStack(const CoupledStack&) = delete;  // the contacts refer to the problem
  CoupledStack& operator=(const CoupledStack&) = delete;

  /// The system of the modelled bodies, at rest; `first`, `first_wall`, `z` are those of it.
  void build();

  void set_sections(int body, const std::vector<HeldSection>& sections);
  void set_material(int body, const Material& material);

  /// Contacts as last found, numbered for the system.
  void stack_contacts();
  /// The bodies' `now` from z.
  void unstack();
  /// Multipliers of the seam after a minimum.
  void update_seams();

  bool any_modelled() const;
  double largest_seam_gap() const;
  /// Smallest RMS radius of the sections' rings.
  double ring_radius() const;
  Points scaled_points(const Points& p) const {
    return (p.rowwise() - scaled.origin.transpose()) / scaled.length;
  }

  CoupledProblem problem;
  CoupledOptions options;
  ScaledBodies scaled;
  std::unique_ptr<BodyContacts> contacts;
  double seam_radius = 0;  ///< of the mouth
  std::unique_ptr<CoupledSystem> system;
  std::unique_ptr<CoupledMinimiser> minimiser;
  StackedContacts stacked;
  std::vector<int> first,
      first_wall;  ///< of each body: its first vertex, its wall; -1: not modelled
  Eigen::VectorXd z;

 private:
  HeldSection scale(const HeldSection& section) const;
  std::vector<HeldSection> scaled_sections(size_t body) const;
  WallEnergy& energy_of(size_t body);

  std::vector<std::unique_ptr<WallEnergy>> energies_;
  std::vector<Vec3> seam_multipliers_;
};

}  // namespace vasorod
