// What belongs to a surface follows an edit of it: arrays, branch labels, ends, binding.
#pragma once

#include "geometry/vertex_source.h"
#include "vessel/prepared_vessel.h"

namespace vasorod {

/// For each edited triangle the input triangle it is a part of.
std::vector<int> triangle_sources(const Triangles& edited, const VertexSources& sources,
                                  const Triangles& input);

/// Puts an edited surface in place of the vessel's. Point arrays are interpolated (integer ones
/// take the dominant source's value), cell arrays follow their triangle, ends keep their loops; an
/// end whose loop is gone is dropped. Returns, for each end there was, its index now or -1. The
/// binding is left stale: bind_again().
std::vector<int> follow_edit(PreparedVessel& vessel, const TriangleSurface& edited,
                             const VertexSources& sources);

/// Binds every vertex anew to the vessel's rest rod [6]; nothing is interpolated.
void bind_again(PreparedVessel& vessel);

}  // namespace vasorod
