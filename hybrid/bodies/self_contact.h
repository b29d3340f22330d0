// A wall that touches itself: inside, where opposite walls of a flattened lumen meet, and outside,
// where folds and kinks close.
//
// From every vertex a ray goes along its normal, outwards and inwards, to the first wall that faces
// it. The gap is measured between the faces that meet: the outer faces outside, the inner faces
// inside,
//
//   g = d - 2 o - min(0, the same at rest),   o: from the surface to that face
//
// with d the height over the tangent plane of the wall that was hit. Every vertex is a slave with
// half its area, so that two walls in contact carry the pressure once.
//
// A wall that is bent sharply is not in contact with itself: what is nearer along the surface than
// half a turn of the wall about its own face, or a few edges, does not count. Nor do rims of open
// ends and what the caller excludes.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "bodies/found_contacts.h"

namespace vasorod {

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
  struct Meeting;
  class Neighbours;
  Meeting meeting(const class RayHits& rays, const TriangleSurface& now, const Points& normals,
                  int vertex, bool outside, double farthest) const;
  double allowance(const Meeting& meeting, int vertex, bool outside) const;

  ContactSide side_;
  std::array<double, 2> offset_;  // from the surface to the inner, outer face
  double stiffness_;
  Eigen::VectorXd area_;
  double edge_;  // mean
  std::unique_ptr<Neighbours> neighbours_;
  std::vector<int> opposite_;  // per slot: a vertex of the wall met last; -1: none
  // Of the last search of the whole wall: where it was, and per slot how far it may move before
  // something comes within reach.
  Points searched_;
  std::vector<double> clearance_;
  std::vector<double> never_;  // per slot: infinite where nothing is searched, else 0
};

}  // namespace vasorod
