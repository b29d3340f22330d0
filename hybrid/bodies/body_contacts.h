// The contacts of a BodyProblem: the pairs of scaled bodies that come within reach, and their state
// between minimisations.
#pragma once

#include <memory>
#include <mutex>
#include <optional>

#include "bodies/found_contacts.h"
#include "bodies/scaled_bodies.h"
#include "bodies/surface_options.h"

namespace vasorod {

/// State of the contacts after a minimisation.
struct ContactState {
  /// Deepest penetration at the current closest features, scaled length.
  double penetration = 0;
  /// Change of the contact forces in the last multiplier update over their sum.
  double force_change = 0;
  /// Farthest that walls that stick to each other slid since the last search, scaled length.
  double slip = 0;
  /// Whether the set of contacts that carry pressure changed.
  bool pressed_changed = false;
  /// Bodies not among the unknowns that a contact now presses on.
  std::vector<int> touched;
};

/// The contacts of one minimisation: `points` in the numbering of the stack, for the energy; the
/// other fields in the numbering of the bodies, for the report. One entry per contact.
struct StackedContacts {
  std::vector<ContactPoint> points;
  std::vector<int> pair;                   ///< index into BodyProblem::contacts
  std::vector<std::array<int, 2>> bodies;  ///< the slave body and the master body
  std::vector<int> slave;                  ///< vertex of the slave body
  std::vector<std::array<int, 3>> master;  ///< vertices of the master body
};

class UnmetCriteria;
/// Whether no body is to join the unknowns, and no criterion exceeds its tolerance of the options
/// times `slackness`.
bool is_settled(const ContactState& state, const SurfaceOptions& options, double slackness = 1);
/// Lists what is_settled() finds wrong, with slackness 1.
void require_contact(const ContactState& state, const SurfaceOptions& options,
                     UnmetCriteria& unmet);

/// Contacts of all pairs of a problem, a body and itself among them. All values in scaled units.
class BodyContacts {
 public:
  /// `problem` must outlive this. `stiffness`: SurfaceOptions::contact_stiffness.
  BodyContacts(const BodyProblem& problem, const ScaledBodies& scaled, double stiffness);

  /// Sets the multipliers to the pressures at the bodies' current positions, then finds the closest
  /// features again.
  ContactState refresh(const ScaledBodies& scaled);
  /// The same with the features found last, and walls that stick do so where they are now.
  ContactState update(const ScaledBodies& scaled);

  /// Where the last update changed all multipliers by the same factor times what the one before
  /// did: adds what all further ones would (Aitken's delta-squared process; for vectors: Macleod,
  /// Acceleration of vector sequences by multi-dimensional delta-2 methods, 1986). False: nothing
  /// was added.
  bool extrapolate();

  /// Pressures per body and vertex with which different bodies that come within reach for the first
  /// time press, scaled stress; an empty one: none. Pairs with exchanged roles begin without.
  void expect(std::vector<Eigen::VectorXd> pressure) { expected_ = std::move(pressure); }

  /// What touches itself is not looked for: something else keeps it apart.
  void leave_out_own() { without_own_ = true; }

  /// Walls that press on each other stick between searches from here on (contact_pair.h): where
  /// the set of those that press does not settle.
  void hold();

  /// From the next search on, walls that a seam joins touch each other right up to it; before, they
  /// touch from one edge beside the seam on. Of all pairs the vertices of both are looked at, those
  /// of obstacles too; before, only one body's: the sharp edge of a fold passes between the
  /// vertices of the other. What is joined meets itself up to the seam too. What lies in each other
  /// then may stay so until allow().
  void meet_up_to_seams();
  /// FoundContacts::allow() of all pairs.
  void allow(double share);
  /// FoundContacts::walls_are_parted() of all pairs.
  void walls_are_parted();
  /// Forgets all contacts with their multipliers.
  void forget();

  /// Finds what touches itself again, at the bodies' current positions, and keeps the multipliers.
  /// A collapse can bring walls together within one minimisation. False: nothing was searched.
  bool follow(const ScaledBodies& scaled);

  /// Smallest gap of any wall from itself at the bodies' current positions, between the walls found
  /// last, scaled length; infinite where none face each other.
  double gap_from_itself(const ScaledBodies& scaled) const;

  /// The contacts numbered for the stack. `first` is the first row of each body in the stack, -1
  /// for a body that is not among the unknowns.
  StackedContacts stacked(const ScaledBodies& scaled, const std::vector<int>& first) const;

  /// Whether the bodies of a pair have come within reach at any time so far; of a body and itself,
  /// whether it has touched itself.
  bool within_reach(int pair) const { return pairs_[static_cast<size_t>(pair)].in_reach; }

  /// Whether any contact carried pressure at the last refresh.
  bool pressing() const;

  /// Whether the vertices of both bodies of a pair are looked at.
  bool seen_from_both(int pair) const;

  /// ContactPair::swallowed of a pair.
  int swallowed(int pair) const;

  /// How deep the rigid ends of a pair are held inside each other, scaled length. Contact near them
  /// is left out.
  double held_depth(int pair) const { return pairs_[static_cast<size_t>(pair)].held_depth; }

  /// Smallest gap of a pair at the bodies' current positions, scaled length; infinite when no walls
  /// face each other. `search`: look for the closest features where none are known, which changes
  /// the contacts.
  double smallest_gap(int pair, const ScaledBodies& scaled, bool search = true);

 private:
  struct Pair {
    int entry = 0;  ///< index into BodyProblem::contacts
    int slave = 0, master = 0;
    bool exchanged = false;  ///< see meet_up_to_seams() and SurfaceBody::edged
    bool in_reach = false;   ///< at any time so far
    double held_depth = 0;
    std::unique_ptr<FoundContacts> contact;
    std::vector<int> pressed;
    Points searched;    ///< of a body and itself: where its walls were at the last search
    double shape = -1;  ///< of a body and itself: how far its walls leave the rod's sections before
                        ///< they are looked at, scaled length; -1: not computed yet
    bool own() const { return slave == master; }  ///< a body and itself
  };
  /// What one pair adds to a ContactState: all but `force_change`, of which it has both sums.
  struct Searched {
    ContactState state;
    double change = 0, sum = 0;
  };
  bool is_edged(const Pair& pair) const;
  void exchange(size_t pair);  ///< adds the same pair with the roles of slave and master exchanged
  enum class Features { anew, as_found };
  Searched search(Pair& pair, const ScaledBodies& scaled, Features features) const;
  ContactState state(const ScaledBodies& scaled, Features features);
  static bool keeps_its_shape(Pair& pair, const ScaledBody& body);
  std::unique_ptr<FoundContacts> between(Pair& pair, const ScaledBodies& scaled) const;
  std::unique_ptr<FoundContacts> within(const Pair& pair, const ScaledBodies& scaled) const;
  double stiffness_of(const Pair& pair, const ScaledBodies& scaled) const;

  ContactWall wall_of(int body, const ScaledBodies& scaled) const;
  bool joined(const Pair& pair) const;
  std::vector<int> seam_of(int body) const;

  const BodyProblem& problem_;
  double stiffness_;
  std::vector<Eigen::VectorXd> expected_;
  bool without_own_ = false, hold_ = false, up_to_seams_ = false, parted_ = false;
  double allowed_ = 0;
  mutable std::vector<std::optional<ContactWall>> walls_;  ///< of the bodies, made when asked for
  mutable std::mutex making_walls_;
  /// One per contact of the problem, then, after meet_up_to_seams(), those whose roles are
  /// exchanged.
  std::vector<Pair> pairs_;
};

}  // namespace vasorod
