// What the finite-element models need of a mesh, as plain arrays; deal.II (triangulation, FE_Q numbering,
// MappingQ, Gauss points) is behind it, in mesh.cpp. Meshes are structured blocks of the parameter cube
// mapped by an exact chart: through degree-p mapping points taken from the chart, a tube's geometry is exact
// to O(h^(p+1)) and no manifold is needed.
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "geometry/types.h"

namespace vasorod::fem {

/// A structured block. First direction (around a tube) may close on itself. Right-handed: for a tube (angle,
/// abscissa, depth).
struct Block {
  std::array<int, 3> cells{1, 1, 1};  ///< the third is ignored by surface meshes
  bool closed = false;                ///< periodic in the first direction; needs at least 3 cells there
  int degree = 3;                     ///< p of FE_Q and of the mapping, 1 to 8
};

/// From parameters in [0, 1]^3 (surface meshes: third 0) to the rest configuration, length.
using Chart = std::function<Vec3(const Vec3&)>;

struct CellRow {
  int cell = 0;
  Eigen::VectorXd shape;  ///< value of each of the cell's nodes' shape functions
};

/// Nodes, connectivity and quadrature data of FE_Q(p) on a block: dim = 3 (solid) or 2 (surface in space).
struct Mesh {
  int dim = 3, degree = 3;
  Block block;
  Points nodes;       ///< rest positions, length
  Points parameters;  ///< of each node, in the unit cube
  std::vector<std::vector<int>> cell_nodes;

  Eigen::MatrixXd shape;                 ///< points x nodes of a cell, the same in every cell
  std::vector<Eigen::VectorXd> weights;  ///< per cell: JxW per point, length^dim
  std::vector<Eigen::MatrixXd>
      gradient;  ///< per cell: row 3 q + J is dN/dX_J at point q (tangential on surfaces), 1/length
  std::vector<Eigen::Matrix3Xd> normal;            ///< per cell, surfaces only: unit normal per point
  std::vector<Eigen::Matrix3Xd> point_parameters;  ///< per cell: parameters of the Gauss points

  int cell_count() const { return static_cast<int>(cell_nodes.size()); }
  int node_count() const { return static_cast<int>(nodes.rows()); }
  int point_count() const { return static_cast<int>(shape.rows()); }

  /// Nodes whose parameter `direction` is `value` (0 or 1).
  std::vector<int> nodes_on(int direction, double value) const;
  /// The node nearest a point of the parameter cube (first direction wraps on closed blocks).
  int nearest_node(const Vec3& parameter) const;
  /// Shape functions at any parameters.
  std::vector<CellRow> rows_at(const std::vector<Vec3>& at) const;
};

Mesh make_solid(const Block& block, const Chart& chart);
Mesh make_surface(const Block& block, const Chart& chart);

/// A face of a solid block (direction 0..2, side 0 or 1) with its own quadrature, for tractions and pressure.
struct FaceMesh {
  std::vector<std::vector<int>> nodes;  ///< per face: node numbers of its (p+1)^2 nodes
  Eigen::MatrixXd shape;                ///< points x face nodes
  std::array<Eigen::MatrixXd, 2>
      slope;  ///< derivative along the face's two parameters, right-handed with the outward normal
  Eigen::VectorXd weights;  ///< quadrature weights on the unit square
};
FaceMesh face_of(const Mesh& mesh, int direction, int side);

}  // namespace vasorod::fem
