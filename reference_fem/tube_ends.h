// End sections of a tube's finite-element model: which nodes belong to them, with which arms and weights.
#pragma once

#include "reference_fem/section.h"
#include "reference_fem/solid.h"
#include "reference_fem/tube.h"

namespace vasorod::fem {

/// The section at the tube's start (side 0) or end (side 1); nothing of it fixed or loaded yet. The centre of
/// a soft section is the area mean of its nodes, which is the axis up to the mesh's geometric error.
Section end_section(const Solid& solid, const TubeShape& tube, int side, bool soft);

}  // namespace vasorod::fem
