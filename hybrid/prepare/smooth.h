// Takes the stairs of voxels off a surface.
#pragma once

#include <vasorod/types.h>

namespace vasorod {

/// Whether a surface has the facets of voxels: nine tenths of its area face along an axis, or
/// diagonally between two or three, as a label's surface does.
bool has_stairs(const TriangleSurface& surface);

/// Windowed sinc smoothing (Taubin et al. 1996, VTK), then every point along its normal by the one
/// distance that gives back the volume. Boundaries stay.
void smooth(TriangleSurface& surface);

}  // namespace vasorod
