#include "surgery/edited_vessel.h"

#include <algorithm>
#include <map>
#include <set>

#include "data/index.h"
#include "geometry/triangle_surface.h"
#include "vessel/fork_reach.h"

namespace vasorod {
namespace {

// The loop of the edited surface that corresponds to an end's loop; empty if there is none.
std::vector<int> surviving_loop(const VesselEnd& end, const std::vector<std::vector<int>>& loops,
                                const VertexSources& sources) {
  const std::set<int> before(end.loop.begin(), end.loop.end());
  const auto was_there = [&](int vertex) {
    const auto& from = sources[index(vertex)].vertex;
    return std::all_of(from.begin(), from.end(), [&](int v) { return before.contains(v); });
  };
  for (const auto& loop : loops)
    if (std::all_of(loop.begin(), loop.end(), was_there)) return loop;
  return {};
}

}  // namespace

std::vector<int> triangle_sources(const Triangles& edited, const VertexSources& sources,
                                  const Triangles& input) {
  std::vector<std::vector<int>> around;  // input triangles at each input vertex
  around.resize(static_cast<size_t>(input.size() > 0 ? input.maxCoeff() + 1 : 0));
  for (int t = 0; t < input.rows(); ++t)
    for (int k = 0; k < 3; ++k) around[index(input(t, k))].push_back(t);
  std::vector<int> from(static_cast<size_t>(edited.rows()), 0);
  for (int t = 0; t < edited.rows(); ++t) {
    // The input triangle with the largest share in the three corners of the edited triangle.
    std::map<int, double> share;
    for (int k = 0; k < 3; ++k) {
      const VertexSource& source = sources[index(edited(t, k))];
      for (size_t j = 0; j < source.vertex.size(); ++j)
        for (const int candidate : around[index(source.vertex[j])])
          share[candidate] += source.weight[j];
    }
    double best = 0;
    for (const auto& [candidate, weight] : share)
      if (weight > best + 1e-9) {
        best = weight;
        from[index(t)] = candidate;
      }
  }
  return from;
}

std::vector<int> follow_edit(PreparedVessel& vessel, const TriangleSurface& edited,
                             const VertexSources& sources) {
  for (NamedArray& array : vessel.loaded.point_arrays) {
    if (!array.integer) {
      array.values = interpolate(sources, array.values);
      continue;
    }
    const auto before = array.values;
    array.values.resize(edited.points.rows(), before.cols());
    for (int i = 0; i < edited.points.rows(); ++i)
      array.values.row(i) = before.row(sources[index(i)].dominant());
  }
  if (!vessel.loaded.cell_arrays.empty()) {
    const auto from = triangle_sources(edited.triangles, sources, vessel.vessel.surface.triangles);
    for (NamedArray& array : vessel.loaded.cell_arrays) {
      const auto before = array.values;
      array.values.resize(edited.triangles.rows(), before.cols());
      for (int t = 0; t < edited.triangles.rows(); ++t)
        array.values.row(t) = before.row(from[index(t)]);
    }
  }
  if (vessel.prestress_displacement.rows() > 0)
    vessel.prestress_displacement =
        interpolate(sources, Eigen::MatrixXd(vessel.prestress_displacement));
  vessel.vessel.branch_of = carry_labels(sources, vessel.vessel.branch_of);
  const auto loops = boundary_loops(edited.triangles);
  std::vector<int> now(vessel.vessel.ends.size(), -1);
  std::vector<VesselEnd> surviving;
  for (size_t e = 0; e < now.size(); ++e) {
    VesselEnd end = vessel.vessel.ends[e];
    end.loop = surviving_loop(end, loops, sources);
    if (end.loop.empty()) continue;
    now[e] = static_cast<int>(surviving.size());
    surviving.push_back(std::move(end));
  }
  vessel.vessel.ends = std::move(surviving);
  vessel.vessel.surface = edited;
  return now;
}

void bind_again(PreparedVessel& vessel) {
  bind_wall(vessel.vessel);
}

}  // namespace vasorod
