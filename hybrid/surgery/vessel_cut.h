// A vessel that is cut: its rod and its wall are divided at the section of a pick, one part is
// kept.
#pragma once

#include <string>

#include <vasorod/result.h>

#include "rod/split_rod.h"
#include "surgery/cut.h"
#include "surgery/pick_place.h"
#include "vessel/end_conditions.h"

namespace vasorod {

/// A vessel's rod and wall, cut at the pick's section.
struct VesselCut {
  PickPlace pick;
  int kept_node = 0;                ///< node of the kept end in the kept rod
  Vec3 kept_center = Vec3::Zero();  ///< of the kept end
  RodSide side = RodSide::towards_root;
  RodPart kept;
  double fraction = 0;  ///< kept length over that of the way along the rod
  CutOutcome wall;
};

/// Cuts across the vessel at the pick and keeps the part with the end `keep`. The vessel stays as
/// it is. Throws InputError, beginning with `where`.
VesselCut cut_across(const std::string& where, const PreparedVessel& vessel, const PickSpec& pick,
                     const EndSelector& keep);

/// The conditions of the kept rod: those at remaining nodes, and a clamp at the kept far end if the
/// scene has no entry for it.
RodConditions kept_conditions(const RodConditions& before, const VesselCut& cut);

/// Makes the vessel the kept part, with the cut as its last end. Of the conditions at its ends
/// those of the stump are left out; `rod` are those of its rod.
void keep_part(const VesselCut& cut, const RodConditions& rod, PreparedVessel& vessel,
               VesselConditions& conditions);

/// What the kept part's rim is called in a result.
CutReport report_of(const VesselCut& cut, double tilt_deg);

}  // namespace vasorod
