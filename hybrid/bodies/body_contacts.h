// The contacts of a BodyProblem: pairs of scaled bodies that come within reach, their state between
// minimisations.
#pragma once

#include <optional>

#include "bodies/contact_pair.h"
#include "bodies/scaled_bodies.h"

namespace vasorod {

/// How the contacts stand after a minimisation.
struct ContactState {
  double penetration = 0;   ///< deepest, at the current closest features, scaled length
  double force_change = 0;  ///< by the last multiplier update, over the sum of the contact forces
  bool pressed_changed = false;
  std::vector<int> touched;  ///< bodies not among the unknowns that something now presses
};

/// The contacts of one minimisation: for the energy numbered in the stack, for the report as the
/// bodies number them.
struct StackedContacts {
  std::vector<ContactPoint> points;
  std::vector<int> pair;                   ///< of the problem
  std::vector<int> slave;                  ///< vertex of the slave body
  std::vector<std::array<int, 3>> master;  ///< vertices of the master body
};

class UnmetCriteria;
/// Lists what of a state is beyond the tolerances: penetration over the mean edge, the change of
/// pressures over the pressures, bodies that had not been among the unknowns.
void require_contact(const ContactState& state, double penetration, double force_change,
                     UnmetCriteria& unmet);

class BodyContacts {
 public:
  BodyContacts(const BodyProblem& problem, const ScaledBodies& scaled, double stiffness);

  /// Multipliers take the pressures at the bodies' current positions, then closest features are
  /// found anew.
  ContactState refresh(const ScaledBodies& scaled);

  /// `first` is each body's first row in the stack, -1 where it is not among the unknowns.
  StackedContacts stacked(const ScaledBodies& scaled, const std::vector<int>& first) const;

  bool within_reach(int pair) const { return pairs_[static_cast<size_t>(pair)].in_reach; }
  int slave(int pair) const { return pairs_[static_cast<size_t>(pair)].slave; }
  int master(int pair) const { return pairs_[static_cast<size_t>(pair)].master; }

  /// Whether anything pressed at the last refresh.
  bool pressing() const;

  /// ContactPair::swallowed of a pair.
  int swallowed(int pair) const;

  /// How deep a pair's rigid ends are held inside each other, scaled length; contact beside them is
  /// left out.
  double held_depth(int pair) const { return pairs_[static_cast<size_t>(pair)].held_depth; }

  /// Smallest gap of a pair at the bodies' current positions, scaled length; infinite when nothing
  /// faces.
  double smallest_gap(int pair, const ScaledBodies& scaled);

 private:
  struct Pair {
    int slave = 0, master = 0;
    bool in_reach = false;  ///< has been, at any time
    double held_depth = 0;
    std::optional<ContactPair> contact;
    std::vector<int> pressed;
  };
  void create(Pair& pair, const ScaledBodies& scaled);

  const BodyProblem& problem_;
  double stiffness_;
  std::vector<Pair> pairs_;
};

}  // namespace vasorod
