// Updates a vessel after an edit of its surface: arrays, branch labels, ends, binding.
#pragma once

#include "geometry/vertex_source.h"
#include "vessel/prepared_vessel.h"

namespace vasorod {

/// The input triangle that contains each edited triangle.
std::vector<int> triangle_sources(const Triangles& edited, const VertexSources& sources,
                                  const Triangles& input);

/// Replaces the vessel's surface by an edited one. Point arrays and the prestress' displacement are
/// interpolated (integer arrays take the value of the dominant source), cell arrays follow their
/// triangle, ends keep their loops; an end without a loop is removed. Returns the new index of each
/// old end, or -1. The binding is then out of date: call bind_again().
std::vector<int> follow_edit(PreparedVessel& vessel, const TriangleSurface& edited,
                             const VertexSources& sources);

/// Computes the binding of all vertices to the vessel's rest rod again [6]; nothing is
/// interpolated.
void bind_again(PreparedVessel& vessel);

}  // namespace vasorod
