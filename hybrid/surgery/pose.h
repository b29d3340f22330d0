// Where the mouth of the cut vessel is put on the recipient before anything is solved (design.md
// section 2, step 3).
#pragma once

#include <functional>

#include <vasorod/types.h>

namespace vasorod {

/// Unit outward normal of the surface at `point`, averaged over the patch connected to it within
/// `radius` (length unit) with weights that fall to zero there, so that neither a coarse triangle
/// nor a bump decides and the far wall of a thin vessel does not take part.
Vec3 outward_normal(const TriangleSurface& surface, const Vec3& point, double radius);

/// The mouth's section on the recipient: position `pick`; the axis from the far kept end to the
/// mouth, against `outward` (unit), so that the vessel comes from outside; the section turned by
/// `phi` (radians, right-handed about -outward) from the pose at which d1 points along the
/// recipient's rod. `towards_mouth`: the rod's d3 points from the far end to the mouth; false: away
/// from it, and the pose's d2, d3 are turned round accordingly.
Pose mouth_pose(const Vec3& pick, const Vec3& outward, const Vec3& recipient_tangent, double phi,
                bool towards_mouth = true);

/// The smallest value of a function of an angle (radians, period 2 pi) and where it is taken.
struct CircleMinimum {
  double angle = 0;  ///< in [-pi, pi]
  double value = 0;
};

/// Tries `samples` angles evenly, then narrows down round the best by golden section to `tolerance`
/// radians. Never worse than the best sample, whatever the function; values that are not finite
/// count as infinitely bad.
CircleMinimum minimise_on_circle(const std::function<double(double)>& function, int samples = 24,
                                 double tolerance = 1e-4);

}  // namespace vasorod
