// The names of a vessel's ends: those that its surface file gives, and those for a scene.
#pragma once

#include <vector>

#include <vasorod/scene.h>

#include "surface_file/read_surface.h"
#include "vessel/vessel.h"

namespace vasorod {

/// Fills VesselEnd::face: each end has the name of the lid whose centre is nearest to its own and
/// at most its radius away.
void name_ends(Vessel& vessel, const std::vector<Lid>& lids);

/// How a scene names an end: by its face where it has one of its own, else `start`, `end` of two
/// ends, or a place rounded to a thousandth of the radius.
EndSelector selector_of(const Vessel& vessel, int end);

}  // namespace vasorod
