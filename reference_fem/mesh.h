// The mesh data of the finite-element models as plain arrays. deal.II provides triangulation, FE_Q
// numbering, MappingQ and Gauss points. Every mesh lives in a parameter cube that an exact chart
// maps to space. The corners of a cell are parameters; the mapping's degree-p points are their
// multilinear interpolation mapped by the chart (like a deal.II ChartManifold). A tube's geometry
// is therefore exact to O(h^(p+1)), for a structured block and for cells from a file (mesh_file.h).
#pragma once

#include <array>
#include <functional>
#include <vector>

#include <vasorod/types.h>

#include "reference_fem/processes.h"

namespace vasorod::fem {

/// A structured block. The first direction (around a tube) may be periodic. Right-handed: for a
/// tube (angle, abscissa, depth).
struct Block {
  std::array<int, 3> cells{1, 1, 1};  ///< the third is ignored by surface meshes
  bool closed = false;  ///< periodic in the first direction; needs at least 3 cells there
  int degree = 3;       ///< p of FE_Q and of the mapping, 1 to 8
};

/// Maps parameters in [0, 1]^3 to the rest configuration, length. For surface meshes the chart
/// chooses the third parameter.
using Chart = std::function<Vec3(const Vec3&)>;

/// Shape functions of a cell at one point.
struct CellRow {
  int cell = 0;
  Eigen::VectorXd shape;  ///< value of the shape function of each of the cell's nodes
};

/// Nodes, connectivity and quadrature data of FE_Q(p): dim = 3 (solid) or 2 (surface in space).
struct Mesh {
  int dim = 3, degree = 3;
  bool closed = false;                       ///< the first parameter has period 1
  Points nodes;                              ///< rest positions, length
  Points parameters;                         ///< of each node, in the unit cube
  std::vector<std::vector<int>> cell_nodes;  ///< per cell: node numbers
  /// Per cell: parameters of its 2^dim corners, in deal.II's order; beyond [0, 1) if the cell
  /// crosses the seam.
  std::vector<Eigen::Matrix3Xd> corners;
  /// Per cell: the process that evaluates the cell. The arrays per cell below are empty on others.
  std::vector<int> owner;

  Eigen::Matrix3Xd unit_points;          ///< Gauss points in the unit cell, the same in every cell
  Eigen::MatrixXd shape;                 ///< points x nodes of a cell, the same in every cell
  std::vector<Eigen::VectorXd> weights;  ///< per cell: JxW per point, length^dim
  /// Per cell: row 3 q + J is dN/dX_J at point q (tangential on surfaces), 1/length.
  std::vector<Eigen::MatrixXd> gradient;
  std::vector<Eigen::Matrix3Xd> normal;  ///< per cell, surfaces only: unit normal per point
  std::vector<Eigen::Matrix3Xd> point_parameters;  ///< per cell: parameters of the Gauss points

  int cell_count() const { return static_cast<int>(cell_nodes.size()); }
  int node_count() const { return static_cast<int>(nodes.rows()); }
  int point_count() const { return static_cast<int>(shape.rows()); }

  /// Nodes whose parameter in `direction` is `value` (0 or 1).
  std::vector<int> nodes_on(int direction, double value) const;
  /// The node nearest to a point of the parameter cube (periodic in the first direction if closed).
  int nearest_node(const Vec3& parameter) const;
  /// Shape functions at given parameters inside the mesh.
  std::vector<CellRow> rows_at(const std::vector<Vec3>& at) const;
};

/// `processes`: the processes that share the cells.
Mesh make_solid(const Block& block, const Chart& chart, const Processes& processes = {});
Mesh make_surface(const Block& block, const Chart& chart, const Processes& processes = {});

/// Faces of a solid (edges of a surface) where the parameter in `direction` is 0 or 1, with their
/// quadrature, for tractions, pressure and sections.
struct FaceMesh {
  std::vector<int> cell;                ///< per face: its cell
  std::vector<std::vector<int>> nodes;  ///< per face: node numbers, lexicographic
  std::vector<double> extent;           ///< per face: length (edges) or area in parameters
  Eigen::MatrixXd shape;                ///< points x face nodes
  /// Derivative along the face's two parameters, right-handed with the outward normal (edges have
  /// the first only).
  std::array<Eigen::MatrixXd, 2> slope;
  Eigen::VectorXd weights;  ///< quadrature weights on the unit square or interval
};
FaceMesh face_of(const Mesh& mesh, int direction, int side);

}  // namespace vasorod::fem
