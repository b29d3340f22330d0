// Two surfaces that may touch: the vertices of one, the slave, against the wall of the other, the
// master, where its normals reach them (normal_foot.h).
//
// The gap is between outer walls and counts from rest: g = d - o_slave - o_master - min(0, the same
// at rest), d the height over the master along its interpolated normal, o the way from each surface
// to its outer face. So what overlaps at rest carries no pressure there. Left out: hits on the rim
// of an open end, walls that face the same way (the far wall of a vessel that a shallow one
// overlaps), and the vertices and triangles that the caller excludes.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "bodies/contact_energy.h"
#include "bodies/reach.h"
#include "geometry/closest_point.h"

namespace vasorod {

/// One side of a pair.
struct ContactSide {
  TriangleSurface rest;
  double offset = 0;           ///< from the surface to the wall's outer face, length
  std::vector<char> excluded;  ///< per vertex; empty: none
};

class ContactPair {
 public:
  /// `stiffness`: k of contact_energy.h, stress / length.
  ContactPair(ContactSide slave, ContactSide master, double stiffness);

  /// Finds what faces what at these positions; contacts() are then those with a gap below `reach`
  /// (length). Multipliers survive for vertices that stay in contact's reach.
  void refresh(const Points& slave, const Points& master, double reach);

  /// Numbered within the bodies; the slack is for a moving master.
  const std::vector<ContactPoint>& contacts() const { return contacts_; }

  /// Vertices that lie inside the master facing as its nearest wall does, and did not at rest: they
  /// went past its middle, where the nearest wall no longer is the one they came through.
  int swallowed() const { return swallowed_; }

  /// m = p for the positions given, as after a minimum; returns (change of the contact forces,
  /// their sum), force.
  std::pair<double, double> update_multipliers(const Points& slave, const Points& master);

  /// Gap of a contact at the positions given.
  double gap(const ContactPoint& contact, const Points& slave, const Points& master) const;

 private:
  double allowance(int vertex);
  bool inside_at_rest(int vertex);

  ContactSide slave_, master_;
  double stiffness_;
  Eigen::VectorXd area_, multiplier_;
  Points slave_rest_normals_, master_rest_normals_;
  std::optional<ClosestPoint> rest_, current_;
  std::vector<double> allowance_;  // min(0, gap at rest); not-a-number until asked for
  std::vector<ContactPoint> contacts_;
  int swallowed_ = 0;
};

}  // namespace vasorod
