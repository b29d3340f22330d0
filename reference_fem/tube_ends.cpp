#include "reference_fem/tube_ends.h"

#include <Eigen/Geometry>
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
  const FaceMesh edges = face_of(mesh, direction, side);
  const Eigen::VectorXd share = edges.shape.transpose() * edges.weights;
  std::map<int, double> shares;
  for (std::size_t e = 0; e < edges.nodes.size(); ++e)
    for (std::size_t a = 0; a < edges.nodes[e].size(); ++a)
      shares[edges.nodes[e][a]] += edges.extent[e] * share[static_cast<Eigen::Index>(a)];
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
