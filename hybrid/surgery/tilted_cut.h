// An oblique cut: the plane of the cut is turned, so that the vein's mouth becomes an ellipse.
#pragma once

#include <vector>

#include "surgery/cut.h"

namespace vasorod {

/// How a cut is tilted.
struct CutTilt {
  double degrees = 0;  ///< -75 to 75
  Vec3 axis =
      Vec3::UnitX();  ///< unit vector in the section's plane: the cut's normal turns about it
};

/// The largest tilt, degrees: beyond it, the mouth is more than four times as long as wide.
inline constexpr double largest_tilt = 75;

/// Throws InputError for a tilt beyond the largest.
void check_tilt(double degrees);

/// `section` turned right-handed about its position.
Pose tilted_section(const Pose& section, const CutTilt& tilt);

/// `cut_vessel` along the tilted section. Throws InputError with the largest tilt to that side, in
/// whole degrees, that can be cut, if the tilted plane runs into an open end or a fork: the mouth
/// may only have vertices of branches (one label per vertex in `branch_of`, or empty) that the
/// straight cut's has.
CutOutcome cut_obliquely(const TriangleSurface& surface, const std::vector<int>& branch_of,
                         const Pose& section, const CutTilt& tilt, const Vec3& pick,
                         const Vec3& keep_near);

}  // namespace vasorod
