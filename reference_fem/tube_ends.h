// End sections of a tube's finite-element model: their nodes with arms and weights.
#pragma once

#include <map>

#include "reference_fem/section.h"
#include "reference_fem/shell.h"
#include "reference_fem/solid.h"
#include "reference_fem/tube.h"

namespace vasorod::fem {

/// The section at the tube's start (side 0) or end (side 1), without fixes or loads. The centre of
/// a soft section is the area mean of its nodes: the axis up to the mesh's geometric error.
Section end_section(const Solid& solid, const TubeShape& tube, int side, bool soft);
Section end_section(const Shell& shell, const TubeShape& tube, int side, bool soft);

/// The tube's mid-surface as a shell. The directors point along the section's radii, so the shell
/// occupies the same volume as the solid.
ShellBody tube_body(const TubeShape& tube);

/// Weight of each node on a side of the mesh (direction, side 0 or 1), an edge of a surface or a
/// face of a solid, by extent in the parameters; the sum is 1.
std::map<int, double> parameter_shares(const Mesh& mesh, int direction, int side);

}  // namespace vasorod::fem
