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
// Beside a seam the walls meet at an angle, and their faces would overlap: there o is the share
// that the caller gives (seam_band.h). A wall that has come in through the mouth is not in contact.
//
// The planes are frozen until the next search and know nothing of the walls' curvature: in a
// minimum of walls that meet in a point or on a line, the vertices that press may leave it along
// the wall; the next search then finds others, and the two cycle. From hold() on, walls that press
// on each other stick from one search to the next, as those of a wall that touches itself do
// (self_contact.h).
//
// A vertex that was outside is looked at again when it and the master may have come within reach
// since then, by how far both went.
//
// Left out are: hits on the rim of an open end; walls that face the same way (the far wall of a
// vessel that a shallow one overlaps); the vertices and triangles that the caller excludes.
#pragma once

#include <vector>

#include "bodies/found_contacts.h"
#include "geometry/normals_on_demand.h"

namespace vasorod {

/// Contacts between one slave and one master surface.
class ContactPair : public FoundContacts {
 public:
  /// `stiffness`: k of contact_energy.h, stress / length.
  ContactPair(ContactSide slave, ContactSide master, double stiffness);

  void refresh(const Points& slave, const Points& master, double reach) override;
  void walls_are_parted() override;

 private:
  // Where a vertex was when it was last looked at.
  struct Looked {
    double distance = 0;  // outside the master, length; 0: not outside
    double travel = 0;    // travel_ then
    Vec3 place = Vec3::Zero();
    int triangle = -1;  // of the master, nearest then; -1: not looked at
  };

  bool is_clear(int vertex, const Vec3& place, double margin) const;
  double allowance(int vertex);
  bool inside_at_rest(int vertex);

  ContactSide slave_, master_;
  double stiffness_;
  double deepest_;  // overlap beyond which walls are not in contact, length
  NormalsOnDemand slave_rest_normal_, master_rest_normal_;
  std::vector<Looked> looked_;
  double travel_ = 0;  // sum over all searches of the farthest that a vertex of the master went
  Points master_then_;
  std::vector<double> allowance_;  // min(0, gap at rest); NaN until computed
};

}  // namespace vasorod
