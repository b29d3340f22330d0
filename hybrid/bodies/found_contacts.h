// The contacts of one pair of walls with their multipliers, however they are found.
#pragma once

#include <utility>
#include <vector>

#include "bodies/contact_energy.h"
#include "bodies/contact_wall.h"

namespace vasorod {

/// One side of a pair.
struct ContactSide {
  ContactWall wall;
  double offset = 0;          ///< from the surface to the wall's outer face, length
  std::vector<double> share;  ///< per vertex: of `offset` that counts; 0: left out; empty: all 1
  bool joined = false;        ///< to the other side's vessel, by a seam; or roles are exchanged
  /// Vertices left out themselves are corners of triangles that are not; else those are, too.
  bool met_up_to_seam = false;
  std::vector<int> seam;  ///< where walls meet up to it: its vertices on this side
  bool left_out(int vertex) const {
    return !share.empty() && share[static_cast<size_t>(vertex)] == 0;
  }
};

/// Contacts between one slave and one master surface.
class FoundContacts {
 public:
  virtual ~FoundContacts() = default;

  /// Finds the facing features at these positions. contacts() then holds those with a gap below
  /// `reach` (length). Multipliers are kept for vertices that stay within reach.
  virtual void refresh(const Points& slave, const Points& master, double reach) = 0;

  /// From the next search on, walls that press on each other stick until the one after, and what
  /// presses and is not found again keeps its plane.
  void hold() { held_ = true; }

  /// From the next search on, nothing lies deep in a wall that it meets up to the seam: what seems
  /// so is a wall whose side is mistaken.
  virtual void walls_are_parted() {}

  /// What the next search finds in each other may stay so; then allow() says how far. Walls are so
  /// brought apart in steps.
  void start_parting();
  /// From the next search on, this share (1 to 0) of the depth that start_parting() found is no
  /// overlap.
  void allow(double share) { allowed_ = share; }

  /// Between two searches: walls that stick do so where they are now.
  void hold_here(const Points& slave, const Points& master);

  /// Of contacts whose slots are the slave's vertices: the multipliers of those that the first
  /// search finds, stress; empty: zero.
  void expect(const Eigen::VectorXd& multiplier) {
    if (multiplier.size() == multiplier_.size()) multiplier_ = multiplier;
  }

  /// The contacts, numbered within the bodies; the slack is for a moving master.
  const std::vector<ContactPoint>& contacts() const { return contacts_; }

  /// Number of slave vertices inside the master that face the same way as its nearest wall, and did
  /// not at rest. They have passed the middle of the master, so the nearest wall is no longer the
  /// one they entered through.
  int swallowed() const { return swallowed_; }

  /// Sets m = p at the given positions, as after a minimisation, except where walls press on each
  /// other within `settled`. Returns (change of the contact
  /// forces, sum of the contact forces), force.
  std::pair<double, double> update_multipliers(const Points& slave, const Points& master);

  /// How the changes of the multipliers by the last two updates compare: their scalar product and
  /// their squares, stress squared. All zero where there were no two since go_on().
  struct Changes {
    double last = 0, before = 0, product = 0;
  };
  Changes changes() const;
  /// Changes the multipliers once more by so many times what the last update changed.
  void go_on(double times);

  /// Gap of a contact at the given positions, length.
  static double gap(const ContactPoint& contact, const Points& slave, const Points& master);
  /// How far a contact that sticks slid at the given positions, length.
  static double slip(const ContactPoint& contact, const Points& slave, const Points& master);

 protected:
  /// `slots`: multipliers that are kept, as many as contacts can be told apart. `edge`: mean, of
  /// the slave, length.
  FoundContacts(Eigen::Index slots, double edge)
      : edge_(edge), multiplier_(Eigen::VectorXd::Zero(slots)) {}
  FoundContacts(const FoundContacts&) = default;
  FoundContacts& operator=(const FoundContacts&) = default;
  FoundContacts(FoundContacts&&) = default;
  FoundContacts& operator=(FoundContacts&&) = default;

  /// From the place on the master to the slave's vertex, length.
  static Vec3 apart(const ContactPoint& contact, const Points& slave, const Points& master);
  bool held() const { return held_; }
  /// Walls that press stick until the next search where they are now, with the stiffness at which a
  /// slip of one edge takes a tangential force as large as the normal one.
  void stick(ContactPoint& contact, Eigen::Index slot, const Points& slave,
             const Points& master) const;
  /// Forgets the contacts; add() and keep() afterwards, then end().
  void begin();
  /// Takes a contact with the multiplier of its slot.
  void add(ContactPoint contact, Eigen::Index slot);
  /// What pressed before begin(), if it is held.
  struct Pressed {
    ContactPoint contact;
    Eigen::Index slot;
  };
  const std::vector<Pressed>& pressed() const { return pressed_; }
  /// Takes what pressed in this slot with its plane, sticking. False: nothing did.
  bool keep(Eigen::Index slot, const Points& slave, const Points& master);
  /// The multiplier of a slot.
  double multiplier(Eigen::Index slot) const { return multiplier_[slot]; }
  /// What is added to the slack of the slot's contact, whose gap is this without it, length.
  double allowed_depth(Eigen::Index slot, double gap);
  /// Multipliers of slots that were not taken are zero from here on.
  void end();

  double edge_;  ///< see the constructor
  int swallowed_ = 0;
  /// Length. Where each of two walls is the other's slave, their gaps cannot all be zero, and the
  /// multipliers would grow for ever.
  double settled_ = 0;

 private:
  Eigen::VectorXd multiplier_, kept_;
  Eigen::VectorXd change_, change_before_;  // by the last two updates, per slot; may be empty
  Eigen::VectorXd depth_;  // per slot, at most 0; empty: start_parting() was not called
  bool finds_depth_ = false;
  double allowed_ = 0;
  std::vector<ContactPoint> contacts_;
  std::vector<Eigen::Index> slots_;  // of contacts_
  std::vector<Pressed> pressed_;
  bool held_ = false;  // see hold()
};

}  // namespace vasorod
