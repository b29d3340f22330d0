// Start pose of the cut vessel's mouth on the recipient.
#pragma once

#include <functional>

#include <vasorod/types.h>

namespace vasorod {

/// Unit outward normal of the surface at `point`: the average over the connected patch within
/// `radius` (length unit), with weights that decrease to zero there. A coarse triangle or a bump
/// has little effect, and the far wall of a thin vessel none.
Vec3 outward_normal(const TriangleSurface& surface, const Vec3& point, double radius);

/// The mouth's section on the recipient, at position `pick`. The axis from the kept far end to the
/// mouth points against `outward` (unit), so that the vessel comes from outside. `phi` (radians,
/// right-handed about -outward) rotates the section from the pose in which d1 points along the
/// recipient's rod. `towards_mouth`: the rod's d3 points from the far end to the mouth; false: d3
/// points away from the mouth, and the pose's d2 and d3 are reversed accordingly.
Pose mouth_pose(const Vec3& pick, const Vec3& outward, const Vec3& recipient_tangent, double phi,
                bool towards_mouth = true);

/// The smallest value of a function of an angle (radians, period 2 pi), and its place.
struct CircleMinimum {
  double angle = 0;  ///< in [-pi, pi]
  double value = 0;  ///< the smallest value
};

/// Evaluates `samples` equally spaced angles, then refines around the best by golden section to
/// `tolerance` radians. Never worse than the best sample, for any function. Non-finite values count
/// as infinite.
CircleMinimum minimise_on_circle(const std::function<double(double)>& function, int samples = 24,
                                 double tolerance = 1e-4);

}  // namespace vasorod
