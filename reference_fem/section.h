// An end section: a rigid disk glued to the wall, or a soft section whose mean pose is held or
// loaded.
//
// Mean pose of a soft section, with weights w (sum 1) and rest arms Y = X - X0, sum w Y = 0:
//   sum w x = c,   sum w (R Y) x (x - c) = 0
// (a shell adds its directors: t^2/12 w (R D) x (D + w)). Both are linear in x for a given pose
// (c, R); six multipliers enforce them.
#pragma once

#include <array>
#include <string>
#include <vector>

#include <vasorod/types.h>

namespace vasorod::fem {

/// A displacement (or director) triple of a section: u = c - X0 + (R - I) Y, or w = (R - I) Y.
struct Member {
  int first_dof = 0;
  Vec3 arm = Vec3::Zero();     ///< Y: from the section's rest centre, or the rest director; length
  bool follows_center = true;  ///< false: a director
  double weight = 0;           ///< soft sections: share of the area; directors: that times t^2 / 12
};

/// A section with its supports and loads.
struct Section {
  std::string name;  ///< start or end
  bool soft = false;
  Vec3 center = Vec3::Zero();    ///< rest centre X0, length
  Mat3 axes = Mat3::Identity();  ///< rest frame (d1, d2, d3): `fixed` refers to it
  std::array<bool, 6> fixed{};   ///< x y z rx ry rz
  /// Path of fixed components at the load t: the centre at X0 + t move along fixed axes; the
  /// rotation exp(t rotation) if all three rotations are fixed (one or two fixed rotations do not
  /// change).
  Vec3 move = Vec3::Zero(), rotation = Vec3::Zero();
  /// Dead force and moment, space axes, scaled by t; on components that are not fixed.
  Vec3 force = Vec3::Zero(), moment = Vec3::Zero();
  bool moment_in_body = false;  ///< the moment turns with the section
  std::vector<Member> members;  ///< of the model

  bool rotation_fixed() const { return fixed[3] && fixed[4] && fixed[5]; }
};

}  // namespace vasorod::fem
