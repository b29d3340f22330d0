#include "predict/coarse_vessels.h"

#include "data/index.h"
#include "geometry/closest_point.h"
#include "geometry/triangle_surface.h"
#include "surface_file/remesh.h"
#include "vessel/fork_reach.h"

namespace vasorod {
namespace {

// Three times as long, the bundled infant's mouth has 12 edges around, and its fine walls find no
// minimum near that of the coarse ones.
constexpr double edge_ratio = 2;
// Over the mean radius.
constexpr double longest_edge = 0.4;
constexpr Eigen::Index fewest_vertices = 8000;

// The branch of the nearest vertex of the fine surface.
std::vector<int> branches(const Points& points, const Vessel& fine) {
  const ClosestPoint closest(fine.surface);
  std::vector<int> branch_of;
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const ClosestPoint::Hit hit = closest.query(points.row(i));
    Eigen::Index nearest = 0;
    hit.barycentric.maxCoeff(&nearest);
    branch_of.push_back(fine.branch_of[index(fine.surface.triangles(hit.triangle, nearest))]);
  }
  return branch_of;
}

PreparedVessel coarser(const PreparedVessel& fine, double edge) {
  PreparedVessel coarse = fine;
  Vessel& vessel = coarse.vessel;
  vessel.surface = remesh(fine.vessel.surface, edge);
  if (coarse.obstacle()) return coarse;
  vessel.branch_of = branches(vessel.surface.points, fine.vessel);
  const std::vector<std::vector<int>> loops = boundary_loops(vessel.surface.triangles);
  for (size_t e = 0; e < vessel.ends.size(); ++e) vessel.ends[e].loop = loops[e];
  bind_wall(vessel);
  return coarse;
}

}  // namespace

std::vector<PreparedVessel> coarse_vessels(const std::vector<PreparedVessel>& vessels) {
  std::vector<PreparedVessel> all;
  Eigen::Index vertices = 0;
  for (const PreparedVessel& vessel : vessels)
    if (!vessel.obstacle()) vertices += vessel.vessel.surface.points.rows();
  if (vertices < fewest_vertices) return {};
  for (const PreparedVessel& vessel : vessels) {
    const double edge = edge_ratio * mean_edge_length(vessel.vessel.surface);
    if (!vessel.obstacle() && edge > longest_edge * vessel.vessel.mean_radius) return {};
    all.push_back(coarser(vessel, edge));
  }
  return all;
}

}  // namespace vasorod
