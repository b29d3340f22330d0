#include "predict/coarse_vessels.h"

#include <algorithm>

#include "data/index.h"
#include "geometry/closest_point.h"
#include "geometry/triangle_surface.h"
#include "numerics/threads.h"
#include "vessel/fork_reach.h"

namespace vasorod {
namespace {

// Three times as long, the bundled infant's mouth has 12 edges around, and its fine walls find no
// minimum near that of the coarse ones.
constexpr double edge_ratio = 2;
// Of a vessel that is only touched: it yields, and does not fold beside a seam.
constexpr double touched_edge_ratio = 4;
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
  vessel.surface = *fine.remeshed->of(fine.vessel.surface, edge);
  if (coarse.obstacle()) return coarse;
  vessel.branch_of = branches(vessel.surface.points, fine.vessel);
  const std::vector<std::vector<int>> loops = boundary_loops(vessel.surface.triangles);
  for (size_t e = 0; e < vessel.ends.size(); ++e) vessel.ends[e].loop = loops[e];
  bind_wall(vessel);
  return coarse;
}

}  // namespace

std::vector<PreparedVessel> coarse_vessels(const std::vector<PreparedVessel>& vessels,
                                           const std::set<std::string>& joined) {
  Eigen::Index vertices = 0;
  std::vector<double> edge;
  for (const PreparedVessel& vessel : vessels) {
    const double fine = mean_edge_length(vessel.vessel.surface);
    edge.push_back(edge_ratio * fine);
    if (vessel.obstacle()) continue;
    vertices += vessel.vessel.surface.points.rows();
    const double longest = longest_edge * vessel.vessel.mean_radius;
    if (edge.back() > longest) return {};
    if (joined.count(vessel.spec.name) == 0)
      edge.back() = std::min(touched_edge_ratio * fine, longest);
  }
  if (vertices < fewest_vertices) return {};
  std::vector<PreparedVessel> all(vessels.size());
  in_parallel(threads(), static_cast<int>(all.size()),
              [&](int v) { all[index(v)] = coarser(vessels[index(v)], edge[index(v)]); });
  return all;
}

}  // namespace vasorod
