// What refining does to a bent tube's points and to its moment, on regular and on irregular meshes.
#pragma once

namespace vasorod::bench {

/// Prints a table: tube R 10, L 100, t 1, nu 0.3, bent to half its Brazier curvature between rigid ends.
void refinement();

}  // namespace vasorod::bench
