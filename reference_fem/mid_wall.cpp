#include "reference_fem/mid_wall.h"

namespace vasorod::fem {

WallPoints wall_points(const Mesh& mesh, const DofValues& u, int components,
                       const std::vector<Vec3>& parameters) {
  const std::vector<CellRow> rows = mesh.rows_at(parameters);
  WallPoints points;
  points.rest.resize(static_cast<Eigen::Index>(rows.size()), 3);
  points.current = points.rest;
  for (std::size_t r = 0; r < rows.size(); ++r) {
    Vec3 X = Vec3::Zero(), moved = Vec3::Zero();
    const std::vector<int>& nodes = mesh.cell_nodes[static_cast<std::size_t>(rows[r].cell)];
    for (std::size_t a = 0; a < nodes.size(); ++a) {
      const double N = rows[r].shape[static_cast<Eigen::Index>(a)];
      X += N * mesh.nodes.row(nodes[a]).transpose();
      moved += N * u.segment<3>(static_cast<Eigen::Index>(components) * nodes[a]);
    }
    points.rest.row(static_cast<Eigen::Index>(r)) = X;
    points.current.row(static_cast<Eigen::Index>(r)) = X + moved;
  }
  return points;
}

}  // namespace vasorod::fem
