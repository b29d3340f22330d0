// Two surfaces that may touch: the vertices of the slave surface against the wall of the master
// surface, where the normals of the master reach them (normal_foot.h).
//
// The gap is measured between the outer faces of the walls, relative to rest:
//
//   g = d - o_slave - o_master - min(0, the same at rest)
//
// d is the height over the master along its interpolated normal, o the distance from each surface
// to its outer face. Walls that overlap at rest therefore carry no pressure at rest.
//
// Left out are: hits on the rim of an open end; walls that face the same way (the far wall of a
// vessel that a shallow one overlaps); the vertices and triangles that the caller excludes.
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

/// Contacts between one slave and one master surface.
class ContactPair {
 public:
  /// `stiffness`: k of contact_energy.h, stress / length.
  ContactPair(ContactSide slave, ContactSide master, double stiffness);

  /// Finds the facing features at these positions. contacts() then holds those with a gap below
  /// `reach` (length). Multipliers are kept for vertices that stay within reach.
  void refresh(const Points& slave, const Points& master, double reach);

  /// The contacts, numbered within the bodies; the slack is for a moving master.
  const std::vector<ContactPoint>& contacts() const { return contacts_; }

  /// Number of slave vertices inside the master that face the same way as its nearest wall, and did
  /// not at rest. They have passed the middle of the master, so the nearest wall is no longer the
  /// one they entered through.
  int swallowed() const { return swallowed_; }

  /// Sets m = p at the given positions, as after a minimisation. Returns (change of the contact
  /// forces, sum of the contact forces), force.
  std::pair<double, double> update_multipliers(const Points& slave, const Points& master);

  /// Gap of a contact at the given positions, length.
  double gap(const ContactPoint& contact, const Points& slave, const Points& master) const;

 private:
  double allowance(int vertex);
  bool inside_at_rest(int vertex);

  ContactSide slave_, master_;
  double stiffness_;
  Eigen::VectorXd area_, multiplier_;
  Points slave_rest_normals_, master_rest_normals_;
  std::optional<ClosestPoint> rest_, current_;
  std::vector<double> allowance_;  // min(0, gap at rest); NaN until computed
  std::vector<ContactPoint> contacts_;
  int swallowed_ = 0;
};

}  // namespace vasorod
