// What the finite-element models need of a mesh, as plain arrays; deal.II (triangulation, FE_Q
// numbering, MappingQ, Gauss points) is behind it. Every mesh lives in a parameter cube that an
// exact chart maps to space: the corners of a cell are parameters, the mapping's degree-p points
// are their multilinear interpolation through the chart (what a deal.II ChartManifold does), so a
// tube's geometry is exact to O(h^(p+1)) whether the cells are a structured block or come from a
// file (mesh_file.h).
#pragma once

#include <array>
#include <functional>
#include <vector>

#include <vasorod/types.h>

#include "reference_fem/processes.h"

namespace vasorod::fem {

/// A structured block. First direction (around a tube) may close on itself. Right-handed: for a
/// tube (angle, abscissa, depth).
struct Block {
  std::array<int, 3> cells{1, 1, 1};  ///< the third is ignored by surface meshes
  bool closed = false;  ///< periodic in the first direction; needs at least 3 cells there
  int degree = 3;       ///< p of FE_Q and of the mapping, 1 to 8
};

/// From parameters in [0, 1]^3 (surface meshes: third as the chart likes) to the rest
/// configuration, length.
using Chart = std::function<Vec3(const Vec3&)>;

struct CellRow {
  int cell = 0;
  Eigen::VectorXd shape;  ///< value of each of the cell's nodes' shape functions
};

/// Nodes, connectivity and quadrature data of FE_Q(p): dim = 3 (solid) or 2 (surface in space).
struct Mesh {
  int dim = 3, degree = 3;
  bool closed = false;  ///< the first parameter has period 1
  Points nodes;         ///< rest positions, length
  Points parameters;    ///< of each node, in the unit cube
  std::vector<std::vector<int>> cell_nodes;
  std::vector<Eigen::Matrix3Xd>
      corners;  ///< per cell: parameters of its 2^dim corners, in deal.II's order;
                ///< beyond [0, 1) where a cell lies across the seam
  std::vector<int>
      owner;  ///< per cell: the process that evaluates it; the next arrays are empty elsewhere

  Eigen::Matrix3Xd unit_points;          ///< Gauss points in the unit cell, the same in every cell
  Eigen::MatrixXd shape;                 ///< points x nodes of a cell, the same in every cell
  std::vector<Eigen::VectorXd> weights;  ///< per cell: JxW per point, length^dim
  std::vector<Eigen::MatrixXd>
      gradient;  ///< per cell: row 3 q + J is dN/dX_J at point q (tangential on surfaces), 1/length
  std::vector<Eigen::Matrix3Xd> normal;  ///< per cell, surfaces only: unit normal per point
  std::vector<Eigen::Matrix3Xd> point_parameters;  ///< per cell: parameters of the Gauss points

  int cell_count() const { return static_cast<int>(cell_nodes.size()); }
  int node_count() const { return static_cast<int>(nodes.rows()); }
  int point_count() const { return static_cast<int>(shape.rows()); }

  /// Nodes whose parameter `direction` is `value` (0 or 1).
  std::vector<int> nodes_on(int direction, double value) const;
  /// The node nearest a point of the parameter cube (first direction wraps on closed meshes).
  int nearest_node(const Vec3& parameter) const;
  /// Shape functions at any parameters inside the mesh.
  std::vector<CellRow> rows_at(const std::vector<Vec3>& at) const;
};

/// `processes`: the processes that share the cells.
Mesh make_solid(const Block& block, const Chart& chart, const Processes& processes = {});
Mesh make_surface(const Block& block, const Chart& chart, const Processes& processes = {});

/// Faces of a solid (edges of a surface) where the parameter `direction` is 0 or 1, with their own
/// quadrature, for tractions, pressure and sections.
struct FaceMesh {
  std::vector<int> cell;                ///< per face: the cell it belongs to
  std::vector<std::vector<int>> nodes;  ///< per face: node numbers, lexicographic
  std::vector<double> extent;           ///< per face: length (edges) or area in parameters
  Eigen::MatrixXd shape;                ///< points x face nodes
  std::array<Eigen::MatrixXd, 2>
      slope;                ///< derivative along the face's two parameters, right-handed with
                            ///< the outward normal (edges have the first only)
  Eigen::VectorXd weights;  ///< quadrature weights on the unit square or interval
};
FaceMesh face_of(const Mesh& mesh, int direction, int side);

}  // namespace vasorod::fem
