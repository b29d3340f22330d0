#include "bodies/seam_band.h"

#include <algorithm>

#include "data/index.h"
#include "geometry/edge_paths.h"
#include "geometry/triangle_surface.h"

namespace vasorod {
namespace {

std::unordered_map<int, double> within_edges(const TriangleSurface& surface,
                                             const std::vector<int>& seam, double edges) {
  return EdgePaths(surface, EdgePaths::Measure::edges).within(seam, edges);
}

double width_of_band(const TriangleSurface& surface, double width) {
  return width + 2 * mean_edge_length(surface);
}

}  // namespace

std::vector<char> seam_band(const TriangleSurface& surface, const std::vector<int>& seam,
                            double width) {
  std::vector<char> band(index(surface.points.rows()), 0);
  if (seam.empty()) return band;
  for (const auto& [vertex, edges] : within_edges(surface, seam, 2)) band[index(vertex)] = 1;
  for (const auto& [vertex, way] : EdgePaths(surface).within(seam, width_of_band(surface, width)))
    band[index(vertex)] = 1;
  return band;
}

std::vector<double> seam_share(const TriangleSurface& surface, const std::vector<int>& seam,
                               double width, int edges) {
  std::vector<double> share(index(surface.points.rows()), 1);
  if (seam.empty()) return share;
  const double whole = width_of_band(surface, width);
  for (const auto& [vertex, way] : EdgePaths(surface).within(seam, whole))
    share[index(vertex)] = way / whole;
  for (const auto& [vertex, away] : within_edges(surface, seam, edges)) share[index(vertex)] = 0;
  return share;
}

}  // namespace vasorod
