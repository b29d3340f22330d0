// Joins the arcs of a flow tree into paths. At a fork, the widest and straightest arc continues the
// path; the other arcs start new paths.
#pragma once

#include <optional>

#include "vessel/flow_tree.h"

namespace vasorod {

/// A sequence of arcs from the first end, or from a fork on the parent path, to an end.
struct AxisPath {
  int parent = -1;            ///< path that this path leaves; -1 for the first
  int end = -1;               ///< index of the path's end
  double radius = 0;          ///< typical radius, length
  std::vector<int> vertices;  ///< in the order of the flow
  std::vector<double> u;      ///< first estimate of each vertex's position along the path, length
  bool stub = false;          ///< shorter than half its radius: no axis can be fitted yet
  std::optional<Vec3> foot;   ///< where the path begins, if known beforehand
  double start = 0, finish = 0;  ///< range of u
};

/// All paths of a vessel.
struct AxisPaths {
  std::vector<AxisPath> paths;  ///< parents before children
  std::vector<int> path_of;     ///< per vertex; -1 for points without triangles
};

/// `area`: per vertex, length^2. `centers`: of the ends, in the order of `loops`.
AxisPaths axis_paths(const TriangleSurface& surface, const Eigen::VectorXd& area,
                     const FlowTree& tree, const std::vector<std::vector<int>>& loops,
                     const std::vector<Vec3>& centers);

}  // namespace vasorod
