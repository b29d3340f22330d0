#include <algorithm>
#include <cmath>

#include <vasorod/error.h>

#include "data/sentence.h"
#include "geometry/triangle_surface.h"
#include "rod/rod_search.h"
#include "vessel/centerline.h"
#include "vessel/check_fit.h"
#include "vessel/fork_reach.h"
#include "vessel/path_fit.h"
#include "vessel/rest_rod.h"
#include "vessel/vessel.h"

namespace vasorod {
namespace {

// Checks the assumptions of the fit about the surface.
void check(const TriangleSurface& surface, const std::vector<Edge>& edges,
           const std::vector<std::vector<int>>& loops) {
  if (!surface.points.allFinite())
    throw InputError("a point has a coordinate that is not a finite number");
  const std::vector<int> label =
      components(surface.triangles, static_cast<int>(surface.points.rows()));
  const int pieces = 1 + *std::max_element(label.begin(), label.end());
  if (pieces != 1)
    throw InputError("the surface has " + std::to_string(pieces) +
                     " separate pieces, expected one");
  if (loops.empty())
    throw InputError(
        "the surface is closed, it has no open ends; expected at least two (cut the caps off)");
  if (loops.size() == 1)
    throw InputError("the surface has one open end near " +
                     place_text(perimeter_centroid(surface.points, loops[0])) +
                     ", expected at least two");
  double widest = 0;
  for (const auto& loop : loops) widest = std::max(widest, perimeter(surface.points, loop));
  for (const auto& loop : loops) {
    const double length = perimeter(surface.points, loop);
    if (length < 0.1 * widest)
      throw InputError(
          "the boundary loop of " + std::to_string(loop.size()) + " edges near " +
          place_text(perimeter_centroid(surface.points, loop)) + " is " + std::to_string(length) +
          " long, a hole rather than an end; expected ends of comparable size (close the hole)");
  }
  const auto vertices = std::count(label.begin(), label.end(), 0);
  const auto euler =
      vertices - static_cast<std::ptrdiff_t>(edges.size()) + surface.triangles.rows();
  const auto handles = 2 - static_cast<std::ptrdiff_t>(loops.size()) - euler;
  if (handles != 0)
    throw InputError("the surface has " + std::to_string(handles / 2) +
                     " handle(s): its branches close a ring; expected a tree of tubes");
}

// The branch whose section contains each vertex. A vertex belongs to the curve on whose arc it
// lies; near a fork, to the closer curve, with distances measured in radii.
std::vector<int> branches_of(const TriangleSurface& surface, const Centerline& centerline,
                             const RestRod& rod) {
  const auto n = static_cast<size_t>(surface.points.rows());
  std::vector<int> branch(n, 0);
  if (rod.tree.branches.size() == 1) return branch;
  const RodSearch search(rod.tree);
  std::vector<int> every(rod.tree.branches.size());
  for (size_t k = 0; k < every.size(); ++k) every[k] = static_cast<int>(k);
  for (size_t c = 0; c < centerline.curves.size(); ++c) {
    // Where this curve's vertices may lie on the wall of another: the curve itself, its parent, its
    // children.
    std::vector<int> around = rod.branches_of[c];
    const int parent = centerline.curves[c].parent;
    if (parent >= 0)
      around.insert(around.end(), rod.branches_of[static_cast<size_t>(parent)].begin(),
                    rod.branches_of[static_cast<size_t>(parent)].end());
    for (size_t k = 0; k < centerline.curves.size(); ++k)
      if (centerline.curves[k].parent == static_cast<int>(c))
        around.insert(around.end(), rod.branches_of[k].begin(), rod.branches_of[k].end());
    const AxisPath& path = centerline.paths.paths[c];
    for (size_t i = 0; i < path.vertices.size(); ++i) {
      const int v = path.vertices[i];
      bool near_fork = parent >= 0 && centerline.position[static_cast<size_t>(v)] <
                                          centerline.curves[c].clean_start;
      for (const auto& fork : centerline.curves[c].forks)
        near_fork |= centerline.position[static_cast<size_t>(v)] > fork[0] &&
                     centerline.position[static_cast<size_t>(v)] < fork[1];
      branch[static_cast<size_t>(v)] =
          search.find(surface.points.row(v), near_fork ? around : rod.branches_of[c], near_fork)
              .branch;
    }
  }
  for (size_t v = 0; v < n; ++v)
    if (centerline.paths.path_of[v] < 0)
      branch[v] = search.find(surface.points.row(static_cast<Eigen::Index>(v)), every, true).branch;
  return branch;
}

// Whether the nearest axis only bridges open sections there.
bool beside_fork(const Centerline& centerline, const Vec3& p) {
  double nearest = HUGE_VAL;
  bool beside = false;
  for (std::size_t c = 0; c < centerline.curves.size(); ++c) {
    const AxisCurve& curve = centerline.curves[c];
    if (curve.axis.control.empty()) continue;
    const double u = closest_parameter(curve.axis, p, centerline.paths.paths[c].radius);
    const double distance = (curve.axis(u) - p).norm();
    if (distance >= nearest) continue;
    nearest = distance;
    beside = (curve.parent >= 0 && u < curve.clean_start) ||
             std::any_of(curve.forks.begin(), curve.forks.end(),
                         [&](const auto& fork) { return u > fork[0] && u < fork[1]; });
  }
  return beside;
}

double mean_radius(const RodTree& tree) {
  double sum = 0, length = 0;
  for (const RodElement& e : tree.elements) {
    sum += e.length * 0.5 *
           (tree.radius[static_cast<size_t>(e.first)] + tree.radius[static_cast<size_t>(e.second)]);
    length += e.length;
  }
  return sum / length;
}

Vessel fit(const TriangleSurface& surface, const FitOptions& options) {
  if (surface.triangles.rows() == 0) throw InputError("the surface has no triangles");
  const std::vector<Edge> edges = edges_of(surface.triangles);
  const std::vector<std::vector<int>> loops = boundary_loops(surface.triangles);
  check(surface, edges, loops);

  const Centerline centerline = fit_centerline(surface, edges, loops);
  RestRod rod = rest_rod(centerline, options.spacing > 0 ? options.spacing : 0.25,
                         surface.points.row(loops[0].front()));

  check_length(rod.tree);
  check_bend(rod.tree);
  check_inside(rod.tree, surface, [&](const Vec3& p) { return beside_fork(centerline, p); });

  Vessel vessel;
  vessel.surface = surface;
  vessel.branch_of = branches_of(surface, centerline, rod);
  vessel.rod = std::move(rod.tree);
  bind_wall(vessel);
  vessel.mean_radius = mean_radius(vessel.rod);
  vessel.ends.resize(loops.size());
  for (size_t k = 0; k < loops.size(); ++k) {
    VesselEnd& end = vessel.ends[k];
    end.loop = loops[k];
    end.center = perimeter_centroid(surface.points, loops[k]);
    // Boundary loops have the surface on their left, so their area vector points into the vessel.
    end.outward = -area_vector(surface.points, loops[k]).normalized();
  }
  for (size_t c = 0; c < centerline.curves.size(); ++c) {
    const int last = rod.branches_of[c].back();
    vessel.ends[static_cast<size_t>(centerline.curves[c].end)].node =
        vessel.rod.branches[static_cast<size_t>(last)].nodes.back();
  }
  return vessel;
}

}  // namespace

Vessel fit_vessel(const std::string& name, const TriangleSurface& surface,
                  const FitOptions& options) {
  try {
    return fit(surface, options);
  } catch (const InputError& e) {
    throw InputError("vessel " + name + ": " + e.what());
  }
}

}  // namespace vasorod
