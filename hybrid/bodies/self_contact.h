// A wall that touches itself: inside, where opposite walls of a flattened lumen meet, and outside,
// where folds and kinks close.
//
// From every vertex a ray goes along its normal, outwards and inwards, to the first wall that faces
// it. The gap is measured between the faces that meet: the outer faces outside, the inner faces
// inside,
//
//   g = n.(x - y) - 2 o - min(0, the same at rest),   o: from the surface to that face
//
// with y where the ray hits and n halfway between the two normals. Which of the two it is, a lumen
// or the space between folds, and whether the walls are through each other already, follows from
// how often the surface winds around the space outside the vertex (facing_walls.h), not from
// earlier searches: a step of the path may carry walls through each other by any depth.
//
// Planes that are frozen until the next search know nothing of the wall's curvature: in a minimum
// of walls that meet in a point or on a line, the vertices that press would leave the crest along
// the wall, which costs nothing but their share of the force, without end. The next search then
// finds other vertices, and the two cycle. Walls that press on each other therefore stick until the
// next search, with the stiffness at which a slip of one edge takes a tangential force as large as
// the normal one. The caller accepts a result where nothing slips further than a small share of an
// edge (ContactState::slip); the tangential force that is left is this share of the normal force.
//
// A vertex on a sharp fold may press and yet face nothing at the next search: its normal has turned
// past the wall, which then goes into the other one until it is found again, and so on. From hold()
// on such a vertex keeps its plane as long as it presses.
//
// A wall that is bent sharply is not in contact with itself: what is nearer along the surface than
// half a turn of the wall about its own face, or a few edges, does not count. Nor do rims of open
// ends, where the multipliers of soft sections and of contact would hinder each other, and what the
// caller excludes. The rim of a seam that walls meet up to does, but not from deep inside a wall:
// the lid that closes the mouth of a fold for the winding number may lie on either side of its own
// rim.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "bodies/found_contacts.h"

namespace vasorod {

class FacingWalls;
class NearOnSurface;
struct FacingWall;

/// Contacts of one surface with itself. In `refresh`, slave and master are the same positions.
class SelfContact : public FoundContacts {
 public:
  /// `thickness`: of the wall, length. `stiffness`: k of contact_energy.h, stress / length.
  SelfContact(ContactSide side, double thickness, double stiffness);
  SelfContact(SelfContact&&) noexcept;
  SelfContact& operator=(SelfContact&&) noexcept;
  ~SelfContact() override;

  void refresh(const Points& slave, const Points& master, double reach) override;

 private:
  void search(int vertex, double nearer, double reach);
  // `deepest`: overlap beyond which they are not in contact, length.
  void meet(int vertex, bool outside, const FacingWall& wall, double reach, double deepest);
  bool own(int vertex, const std::array<int, 3>& corner) const;
  double allowance(const FacingWall& wall, int vertex, bool outside) const;
  // The planes of vertices that pressed and face nothing now.
  void keep_planes(const Points& now);

  ContactSide side_;
  std::array<double, 2> offset_;  // from the surface to the inner, outer face
  double stiffness_;
  Eigen::VectorXd area_;
  std::vector<char> on_seam_;  // per vertex
  double deepest_;             // overlap beyond which walls are not in contact, length
  std::unique_ptr<NearOnSurface> near_;
  std::unique_ptr<FacingWalls> walls_;  // made by the first search
  Points now_;                          // of the present search
  // Of the last search of the whole wall: where it was, and per slot (two a vertex: inside,
  // outside) how far the wall may move before something on the vertex's ray comes within reach.
  // Something beside the ray may be nearer.
  Points searched_;
  std::vector<double> clearance_;
  std::vector<double> never_;  // per slot: infinite where nothing is searched, else 0
};

}  // namespace vasorod
