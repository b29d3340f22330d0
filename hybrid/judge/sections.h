// The sections of a deformed vessel: how far each is flattened, and what is left of its lumen.
#pragma once

#include <vector>

#include "vessel/prepared_vessel.h"

namespace vasorod {

/// One section, in the plane of a rod node's d1 and d2.
struct JudgedSection {
  int branch = 0;         ///< index of the rod's branch
  int node = 0;           ///< rod node
  double abscissa = 0;    ///< arc length at rest from the start of the branch, length
  double flattening = 0;  ///< largest 1 - H / H_rest over all directions, H the mid-wall width
  /// Area inside the mid-wall section moved inwards by half the thickness, length^2.
  double lumen = 0, rest_lumen = 0;

  double lumen_ratio() const { return lumen / rest_lumen; }
};

/// The sections of all branches, half a radius apart. `current`: the deformed surface. At rest, the
/// section is the closed curve around the node whose area is 0.3 to 1.7 times the disk's. Deformed,
/// it is the curve that goes once around the rod in the rest shape, however little it still
/// encloses: collapsed sections count. Sections that are not one closed curve (at forks, ends and
/// the incision) are left out.
std::vector<JudgedSection> judged_sections(const PreparedVessel& vessel, const RodPoses& poses,
                                           const Points& current);

/// Lumen and flattening at the nodes of a rod.
struct LumenAlong {
  std::vector<double> area;        ///< length^2; NaN: no section within one radius
  std::vector<double> flattening;  ///< NaN where the area is
};

/// Interpolates linearly between the sections of each branch. Beyond the first and the last one,
/// their values hold for one radius.
LumenAlong lumen_along(const RodTree& rod, const std::vector<JudgedSection>& sections);

}  // namespace vasorod
