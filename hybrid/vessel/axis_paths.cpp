#include "vessel/axis_paths.h"

#include <algorithm>
#include <cmath>

namespace vasorod {
namespace {

// A slice of an arc between two levels, about half a radius thick.
struct Slice {
  Vec3 center = Vec3::Zero();
  double level = 0;  // mean
  double radius = 0, area = 0;
};

struct ArcSlices {
  std::vector<Slice> slices;
  double radius = 0;  // median of the slices
};

double loop_radius(const TriangleSurface& surface, const std::vector<int>& loop) {
  return perimeter(surface.points, loop) / (2 * M_PI);
}

ArcSlices slice_arc(const TriangleSurface& surface, const Eigen::VectorXd& area,
                    const Eigen::VectorXd& level, const FlowArc& arc, double radius) {
  double total = 0;
  for (const int v : arc.vertices) total += area[v];
  // Equal areas are nearly equal lengths. The small number keeps counts that are integers up to
  // round-off. The count is bounded before it becomes an int.
  const double wanted = std::ceil(total / (M_PI * radius * radius) - 1e-6);
  const double most = std::max(1.0, std::floor(static_cast<double>(arc.vertices.size()) / 6));
  const int count = wanted > 1 ? static_cast<int>(std::min(wanted, most)) : 1;
  ArcSlices result;
  result.slices.resize(static_cast<size_t>(count));
  auto slice_at = [&](double accumulated) {
    const double at = accumulated / total * count;
    return at > 0 ? static_cast<size_t>(std::min(at, count - 1.0)) : size_t(0);
  };
  double accumulated = 0;
  for (const int v : arc.vertices) {
    Slice& slice = result.slices[slice_at(accumulated + 0.5 * area[v])];
    slice.center += area[v] * surface.points.row(v).transpose();
    slice.level += area[v] * level[v];
    slice.area += area[v];
    accumulated += area[v];
  }
  for (Slice& slice : result.slices) {
    if (slice.area <= 0) continue;
    slice.center /= slice.area;
    slice.level /= slice.area;
  }
  accumulated = 0;
  for (const int v : arc.vertices) {
    Slice& slice = result.slices[slice_at(accumulated + 0.5 * area[v])];
    slice.radius +=
        area[v] / slice.area * (surface.points.row(v).transpose() - slice.center).norm();
    accumulated += area[v];
  }
  std::erase_if(result.slices, [](const Slice& s) { return s.area <= 0; });
  std::vector<double> radii;
  for (const Slice& slice : result.slices) radii.push_back(slice.radius);
  std::nth_element(radii.begin(), radii.begin() + static_cast<std::ptrdiff_t>(radii.size() / 2),
                   radii.end());
  result.radius = radii[radii.size() / 2];
  return result;
}

Vec3 direction(const Vec3& from, const Vec3& to) {
  const double length = (to - from).norm();
  return length > 0 ? Vec3((to - from) / length) : Vec3::Zero();
}

// The child that continues the path: the one with the largest section area times straightness. A
// wide vessel that turns (the aortic arch) is still the same vessel; of two equally wide branches,
// the straighter one continues.
int continuation(const std::vector<ArcSlices>& arcs, const std::vector<Slice>& before,
                 const std::vector<int>& children) {
  const Vec3 last = before.back().center;
  const Vec3 along =
      before.size() > 1
          ? direction(before[before.size() - std::min<size_t>(4, before.size())].center, last)
          : Vec3::Zero();
  int best = children.front();
  double best_score = -1;
  for (const int child : children) {
    const ArcSlices& arc = arcs[static_cast<size_t>(child)];
    const Vec3 leaving =
        arc.slices.size() > 1
            ? direction(arc.slices.front().center,
                        arc.slices[std::min<size_t>(3, arc.slices.size() - 1)].center)
            : direction(last, arc.slices.front().center);
    const double score = arc.radius * arc.radius * (1.05 + along.dot(leaving));
    if (score > best_score) {
      best_score = score;
      best = child;
    }
  }
  return best;
}

// Position along the path from the level, through the slices' centres. `first`: where the first
// path begins. A branch is extrapolated from its first slices.
void place(AxisPath& path, const Eigen::VectorXd& level, const std::vector<Slice>& slices,
           const Vec3* first, const Vec3& last) {
  std::vector<double> levels, lengths;
  Vec3 previous = slices.front().center;
  auto pass = [&](const Vec3& center, double at) {
    if (!levels.empty() && at <= levels.back()) return;
    lengths.push_back(lengths.empty() ? 0 : lengths.back() + (center - previous).norm());
    levels.push_back(at);
    previous = center;
  };
  if (first != nullptr) pass(*first, 0);
  for (const Slice& slice : slices) pass(slice.center, slice.level);
  pass(last, level[path.vertices.back()]);
  path.finish = lengths.back();
  path.start = 0;
  path.u.reserve(path.vertices.size());
  for (const int v : path.vertices) {
    size_t k = 1;
    if (levels.size() > 2)
      k = static_cast<size_t>(std::upper_bound(levels.begin() + 1, levels.end() - 1, level[v]) -
                              levels.begin());
    const double slope =
        levels.size() > 1 ? (lengths[k] - lengths[k - 1]) / (levels[k] - levels[k - 1]) : 1;
    path.u.push_back(lengths[k - 1] + (level[v] - levels[k - 1]) * slope);
    path.start = std::min(path.start, path.u.back());
  }
}

}  // namespace

AxisPaths axis_paths(const TriangleSurface& surface, const Eigen::VectorXd& area,
                     const FlowTree& tree, const std::vector<std::vector<int>>& loops,
                     const std::vector<Vec3>& centers) {
  const size_t arc_count = tree.arcs.size();
  std::vector<double> guess(arc_count, 0);
  std::vector<std::vector<int>> children(arc_count);
  for (size_t k = arc_count; k-- > 0;) {  // children before parents
    const FlowArc& arc = tree.arcs[k];
    if (arc.end >= 0) guess[k] = loop_radius(surface, loops[static_cast<size_t>(arc.end)]);
    if (k == 0) guess[k] = loop_radius(surface, loops[0]);
    if (arc.parent < 0) continue;
    children[static_cast<size_t>(arc.parent)].push_back(static_cast<int>(k));
    guess[static_cast<size_t>(arc.parent)] =
        std::max(guess[static_cast<size_t>(arc.parent)], guess[k]);
  }
  std::vector<ArcSlices> arcs(arc_count);
  for (size_t k = 0; k < arc_count; ++k)
    arcs[k] = slice_arc(surface, area, tree.level, tree.arcs[k], guess[k]);

  AxisPaths result;
  result.path_of.assign(static_cast<size_t>(surface.points.rows()), -1);
  struct Start {
    int arc, parent;
  };
  std::vector<Start> starts{{0, -1}};
  for (size_t s = 0; s < starts.size(); ++s) {
    AxisPath path;
    path.parent = starts[s].parent;
    std::vector<Slice> slices;
    double weight = 0;
    for (int arc = starts[s].arc;;) {
      const auto k = static_cast<size_t>(arc);
      path.vertices.insert(path.vertices.end(), tree.arcs[k].vertices.begin(),
                           tree.arcs[k].vertices.end());
      slices.insert(slices.end(), arcs[k].slices.begin(), arcs[k].slices.end());
      for (const Slice& slice : arcs[k].slices) {
        path.radius += slice.area * slice.radius;
        weight += slice.area;
      }
      if (children[k].empty()) {
        path.end = tree.arcs[k].end;
        break;
      }
      const int next = continuation(arcs, slices, children[k]);
      for (const int child : children[k])
        if (child != next) starts.push_back({child, static_cast<int>(s)});
      arc = next;
    }
    path.radius /= weight;
    for (const int v : path.vertices) result.path_of[static_cast<size_t>(v)] = static_cast<int>(s);
    place(path, tree.level, slices, s == 0 ? centers.data() : nullptr,
          centers[static_cast<size_t>(path.end)]);
    path.stub = path.parent >= 0 && path.finish - path.start < 0.5 * path.radius;
    result.paths.push_back(std::move(path));
  }
  return result;
}

}  // namespace vasorod
