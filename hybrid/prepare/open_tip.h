// Opens a closed end of a vessel flat across its axis, or takes the branch off.
#pragma once

#include <optional>
#include <vector>

#include "prepare/find_caps.h"
#include "prepare/find_tips.h"

namespace vasorod {

/// A flat section across a vessel's axis.
struct FlatSection {
  Vec3 center = Vec3::Zero();   ///< centroid of its area, length
  Vec3 normal = Vec3::UnitZ();  ///< unit, towards the tip
  double radius = 0;            ///< of the circle of its area, length
};

/// Sections across the axis where a tip may be cut, the best first: half a radius behind the
/// outermost that has 0.97 of the area of the tube behind the tip, then those farther out, then
/// those farther in. None where the wall there has no closed sections.
std::vector<FlatSection> sections_behind_tip(const TriangleSurface& surface, const Tip& tip);

/// Sections along a flat cap, the best first: where the rounding of its rim is over, not far behind
/// it, and the wall has not widened by more than a half; with `known` then also those within the
/// rounding or on a wall that goes on widening, for a cap that is known to be an end. None where
/// the wall there has no such section.
std::vector<FlatSection> sections_behind_cap(const TriangleSurface& surface, const FlatCap& cap,
                                             bool known);

/// From a section on a branch towards its foot: the last before the area grows by half within a
/// radius, where the branch leaves the wall of another.
FlatSection foot_of_branch(const TriangleSurface& surface, const FlatSection& section);

/// Cuts the tip off at the section and leaves a flat open end. False where the plane does not part
/// the tip from the rest by one closed cut; then nothing is changed.
bool cut_tip(TriangleSurface& surface, const Tip& tip, const FlatSection& section);

}  // namespace vasorod
