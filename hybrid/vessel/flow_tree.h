// Splits an open surface into tubular arcs between forks, without seeds.
//
// Potential flow along the wall enters through the first end and leaves through every other in
// proportion to its perimeter, so the potential grows about as fast as the arc length in every
// branch. With positive weights it has no extremum inside: a surface of genus 0 with n ends has
// exactly n - 2 saddles (counted with multiplicity), and the components of the potential's
// superlevel sets merge there like a tree. The arcs of that tree are the vessel's branches, on any
// mesh, however noisy.
#pragma once

#include <vector>

#include "geometry/triangle_surface.h"

namespace vasorod {

/// The part of the surface between two forks, or a fork and an end.
struct FlowArc {
  int parent = -1;            ///< the arc nearer to the first end; -1 for the root arc
  int end = -1;               ///< the end (index into loops) it runs to; -1: to a fork
  std::vector<int> vertices;  ///< ordered by rising level
};

struct FlowTree {
  Eigen::VectorXd level;      ///< the potential per vertex, 0 at the first end, length unit
  std::vector<int> arc_of;    ///< arc per vertex, -1 for points no triangle uses
  std::vector<FlowArc> arcs;  ///< parents before children; arcs[0] holds the first end
};

/// `loops`: the surface's boundary loops, at least two. The surface is connected, of genus 0.
FlowTree flow_tree(const TriangleSurface& surface, const std::vector<Edge>& edges,
                   const std::vector<std::vector<int>>& loops);

}  // namespace vasorod
