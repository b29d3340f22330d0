// Opens the closed ends of a vessel, and says where one probably stays closed.
#pragma once

#include <string>
#include <vector>

#include <vasorod/types.h>

namespace vasorod {

/// Which ends to open; in mm.
struct EndsToOpen {
  std::vector<Vec3> places;       ///< of the ends to open; empty: all that are found
  double cut_branches_below = 0;  ///< radius of the branches to take off instead
};

/// What was done, and what a user should look at.
struct OpenedEnds {
  std::vector<std::string> done, warnings;
};

/// Opens farthest points of the wall across the axis (find_tips, sections_behind_tip), and ends
/// that are too short for that along their flat caps (find_caps, sections_behind_cap). Throws
/// InputError where no closed end is at a place that was named.
OpenedEnds open_ends(TriangleSurface& surface, const EndsToOpen& wanted);

}  // namespace vasorod
