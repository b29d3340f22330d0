// Joins the arcs of a flow tree into paths: at a fork the widest and straightest arc goes on, the
// others branch off.
#pragma once

#include <optional>

#include "vessel/flow_tree.h"

namespace vasorod {

/// A run of arcs from the first end, or from a fork on its parent path, to an end.
struct AxisPath {
  int parent = -1;               ///< path it branches off, -1 for the first
  int end = -1;                  ///< index of the end it runs to
  double radius = 0;             ///< typical, length
  std::vector<int> vertices;     ///< in the order of the flow
  std::vector<double> u;         ///< first estimate of each one's position along the path, length
  bool stub = false;             ///< shorter than half its radius: no axis can be fitted yet
  std::optional<Vec3> foot;      ///< where it begins, as far as that is known beforehand
  double start = 0, finish = 0;  ///< of u
};

struct AxisPaths {
  std::vector<AxisPath> paths;  ///< parents before children
  std::vector<int> path_of;     ///< per vertex, -1 for points no triangle uses
};

/// `area`: per vertex. `centers`: of the ends, in the order of `loops`.
AxisPaths axis_paths(const TriangleSurface& surface, const Eigen::VectorXd& area,
                     const FlowTree& tree, const std::vector<std::vector<int>>& loops,
                     const std::vector<Vec3>& centers);

}  // namespace vasorod
