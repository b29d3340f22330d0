// Where the vein's mouth lies on the recipient, and how its cut is tilted for that.
#pragma once

#include <vasorod/scene.h>

#include "rod/newton.h"
#include "rod/split_rod.h"
#include "surgery/tilted_cut.h"

namespace vasorod {

/// The place of the vein's mouth.
struct MouthPlace {
  RodSolution vein;          ///< equilibrium of the kept rod, its mouth in that place
  RodConditions conditions;  ///< the supports of the kept rod, that of the mouth among them
  double rotation = 0;       ///< about the recipient's normal, radians
  double axis_turn = 0;      ///< of the section's normal d3 from rest, radians
  CutTilt tilt;              ///< of the cut, in the rest shape
};

/// Puts the mouth of the `kept` rod on the recipient's `wall` at the scene's pick, under the
/// conditions `held`. The mouth's axis points against the wall's normal, averaged over
/// `mouth_radius` (length unit), after the smallest rotation from rest and the rotation about the
/// normal with the least twist plus the scene's. If the cut is tilted, the cut's plane takes the
/// place of the section: about an axis in it at right angles to `tangent`, the direction of the
/// recipient's rod, the vein leans by the tilt, with its kept part on the side of `tangent` where
/// the tilt is positive.
MouthPlace place_mouth(const GlennSpec& spec, const Vec3& incision, const RodPart& kept,
                       RodSide side, const RodConditions& held, double mouth_radius,
                       const TriangleSurface& wall, const Vec3& tangent, const RodOptions& options);

}  // namespace vasorod
