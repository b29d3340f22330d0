#include "reference_fem/tube_ends.h"

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <map>

namespace vasorod::fem {

Section end_section(const Solid& solid, const TubeShape& tube, int side, bool soft) {
  const Mesh& mesh = solid.mesh();
  const Pose frame = tube.section(side);
  Section section;
  section.name = side == 0 ? "start" : "end";
  section.soft = soft;
  section.center = frame.position;
  section.axes = frame.rotation;

  std::map<int, double> weight;
  double area = 0;
  const FaceMesh face = face_of(mesh, 1, side);
  for (const std::vector<int>& nodes : face.nodes) {
    const auto n = static_cast<Eigen::Index>(nodes.size());
    Eigen::Matrix3Xd x(3, n);
    for (Eigen::Index a = 0; a < n; ++a) x.col(a) = mesh.nodes.row(nodes[static_cast<std::size_t>(a)]);
    for (Eigen::Index q = 0; q < face.weights.size(); ++q) {
      const Vec3 along = x * face.slope[0].row(q).transpose(), across = x * face.slope[1].row(q).transpose();
      const double w = face.weights[q] * along.cross(across).norm();
      area += w;
      for (Eigen::Index a = 0; a < n; ++a) weight[nodes[static_cast<std::size_t>(a)]] += w * face.shape(q, a);
    }
  }
  if (soft) {
    section.center.setZero();
    for (const auto& [node, w] : weight) section.center += w / area * mesh.nodes.row(node).transpose();
  }
  for (const auto& [node, w] : weight)
    section.members.push_back({3 * node, mesh.nodes.row(node).transpose() - section.center, true, w / area});
  return section;
}

std::map<int, double> edge_shares(const Mesh& mesh, int direction, int side) {
  // five Gauss points on each cell's edge: exact to degree 9
  constexpr std::array<double, 5> at{0.04691007703066802, 0.23076534494715845, 0.5, 0.7692346550528415,
                                     0.9530899229693320};
  constexpr std::array<double, 5> weight{0.11846344252809454, 0.23931433524968324, 0.28444444444444444,
                                         0.23931433524968324, 0.11846344252809454};
  const int other = 1 - direction, cells = mesh.block.cells[static_cast<std::size_t>(other)];
  std::map<int, double> shares;
  for (int c = 0; c < cells; ++c)
    for (std::size_t q = 0; q < 5; ++q) {
      Vec3 parameter = Vec3::Zero();
      parameter[direction] = side;
      parameter[other] = (c + at[q]) / cells;
      const CellRow row = mesh.rows_at({parameter}).front();
      const std::vector<int>& nodes = mesh.cell_nodes[static_cast<std::size_t>(row.cell)];
      for (std::size_t a = 0; a < nodes.size(); ++a)
        if (std::abs(mesh.parameters(nodes[a], direction) - side) < 1e-9)
          shares[nodes[a]] += weight[q] / cells * row.shape[static_cast<Eigen::Index>(a)];
    }
  return shares;
}

Section end_section(const Shell& shell, const TubeShape& tube, int side, bool soft) {
  const Mesh& mesh = shell.mesh();
  const Pose frame = tube.section(side);
  Section section;
  section.name = side == 0 ? "start" : "end";
  section.soft = soft;
  section.center = frame.position;
  section.axes = frame.rotation;
  const std::map<int, double> shares = edge_shares(mesh, 1, side);
  if (soft) {
    section.center.setZero();
    for (const auto& [node, share] : shares) section.center += share * mesh.nodes.row(node).transpose();
  }
  const double t = tube.thickness_at(side);
  for (const auto& [node, share] : shares) {
    section.members.push_back({7 * node, mesh.nodes.row(node).transpose() - section.center, true, share});
    section.members.push_back({7 * node + 3, shell.directors().row(node), false, share * t * t / 12});
  }
  return section;
}

ShellBody tube_body(const TubeShape& tube) {
  return {[tube](const Vec3& p) { return Vec3(tube.axes(p).col(0)); },
          [tube](const Vec3& p) { return tube.thickness_at(p[1]); },
          [tube](const Vec3& p) { return tube.axes(p); }};
}

}  // namespace vasorod::fem
