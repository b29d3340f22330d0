#include "reference_fem/tube_ends.h"

#include <Eigen/Geometry>
#include <map>

namespace vasorod::fem {

namespace {

/// Node and share of the section; shares sum to 1.
using Shares = std::map<int, double>;

/// The section without members. A soft section's centre is the mean of its nodes.
Section place_section(const Mesh& mesh, const TubeShape& tube, int side, bool soft,
                      const Shares& shares) {
  const Pose frame = tube.section(side);
  Section section;
  section.name = side == 0 ? "start" : "end";
  section.soft = soft;
  section.center = frame.position;
  section.axes = frame.rotation;
  if (!soft) return section;
  section.center.setZero();
  for (const auto& [node, share] : shares)
    section.center += share * mesh.nodes.row(node).transpose();
  return section;
}

/// Shares by area.
Shares area_shares(const Mesh& mesh, int direction, int side) {
  Shares shares;
  double area = 0;
  const FaceMesh face = face_of(mesh, direction, side);
  for (const std::vector<int>& nodes : face.nodes) {
    const auto n = static_cast<Eigen::Index>(nodes.size());
    Eigen::Matrix3Xd x(3, n);
    for (Eigen::Index a = 0; a < n; ++a)
      x.col(a) = mesh.nodes.row(nodes[static_cast<std::size_t>(a)]);
    for (Eigen::Index q = 0; q < face.weights.size(); ++q) {
      const Vec3 along = x * face.slope[0].row(q).transpose(),
                 across = x * face.slope[1].row(q).transpose();
      const double w = face.weights[q] * along.cross(across).norm();
      area += w;
      for (Eigen::Index a = 0; a < n; ++a)
        shares[nodes[static_cast<std::size_t>(a)]] += w * face.shape(q, a);
    }
  }
  for (auto& [node, share] : shares) share /= area;
  return shares;
}

}  // namespace

std::map<int, double> parameter_shares(const Mesh& mesh, int direction, int side) {
  const FaceMesh face = face_of(mesh, direction, side);
  const Eigen::VectorXd share = face.shape.transpose() * face.weights;
  Shares shares;
  for (std::size_t f = 0; f < face.nodes.size(); ++f)
    for (std::size_t a = 0; a < face.nodes[f].size(); ++a)
      shares[face.nodes[f][a]] += face.extent[f] * share[static_cast<Eigen::Index>(a)];
  return shares;
}

Section end_section(const Solid& solid, const TubeShape& tube, int side, bool soft) {
  const Mesh& mesh = solid.mesh();
  const Shares shares = area_shares(mesh, 1, side);
  Section section = place_section(mesh, tube, side, soft, shares);
  for (const auto& [node, share] : shares)
    section.members.push_back(
        {3 * node, mesh.nodes.row(node).transpose() - section.center, true, share});
  return section;
}

Section end_section(const Shell& shell, const TubeShape& tube, int side, bool soft) {
  const Mesh& mesh = shell.mesh();
  const Shares shares = parameter_shares(mesh, 1, side);
  Section section = place_section(mesh, tube, side, soft, shares);
  const double t = tube.thickness_at(side);
  for (const auto& [node, share] : shares) {
    section.members.push_back(
        {7 * node, mesh.nodes.row(node).transpose() - section.center, true, share});
    section.members.push_back(
        {7 * node + 3, shell.directors().row(node), false, share * t * t / 12});
  }
  return section;
}

ShellBody tube_body(const TubeShape& tube) {
  return {[tube](const Vec3& p) { return Vec3(tube.axes(p).col(0)); },
          [tube](const Vec3& p) { return tube.thickness_at(p[1]); },
          [tube](const Vec3& p) { return tube.axes(p); }};
}

}  // namespace vasorod::fem
