// Splits an open surface into tubular arcs between forks, without seed points.
//
// A potential flow along the wall enters through the first end and leaves through every other end
// in proportion to its perimeter. The potential therefore grows about as fast as the arc length in
// every branch. With positive weights it has no extremum inside: a surface of genus 0 with n ends
// has exactly n - 2 saddles (counted with multiplicity). The components of the potential's
// superlevel sets merge at these saddles and form a tree. The arcs of this tree are the vessel's
// branches, on any mesh and with any noise.
#pragma once

#include <vector>

#include "geometry/triangle_surface.h"

namespace vasorod {

/// The part of the surface between two forks, or between a fork and an end.
struct FlowArc {
  int parent = -1;            ///< the arc nearer to the first end; -1 for the root arc
  int end = -1;               ///< the arc's end (index into loops); -1: a fork
  std::vector<int> vertices;  ///< in order of increasing level
};

/// The arcs of a surface.
struct FlowTree {
  Eigen::VectorXd level;      ///< the potential per vertex, 0 at the first end, length unit
  std::vector<int> arc_of;    ///< arc per vertex; -1 for points without triangles
  std::vector<FlowArc> arcs;  ///< parents before children; arcs[0] contains the first end
};

/// `loops`: the surface's boundary loops, at least two. The surface is connected and of genus 0.
FlowTree flow_tree(const TriangleSurface& surface, const std::vector<Edge>& edges,
                   const std::vector<std::vector<int>>& loops);

}  // namespace vasorod
