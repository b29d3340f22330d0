#include "vessel/fork_border.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "vessel/path_fit.h"

namespace vasorod {
namespace {

// Distance from the parent's axis over its radius beyond which a point lies outside the tube.
constexpr double outside_tube = 1.2;
constexpr double inside_tube = 1.1;

}  // namespace

AxisPaths redraw_borders(const TriangleSurface& surface, const std::vector<Edge>& edges,
                         const Centerline& first, const std::vector<Vec3>& centers) {
  const auto n = static_cast<size_t>(surface.points.rows());
  const std::vector<AxisPath>& old = first.paths.paths;
  AxisPaths result = first.paths;
  std::vector<double> position = first.position;
  auto point = [&](size_t v) { return Vec3(surface.points.row(static_cast<Eigen::Index>(v))); };

  for (size_t q = 1; q < old.size(); ++q) {
    const auto c = static_cast<size_t>(old[q].parent);
    if (old[c].stub) continue;
    const AxisCurve& curve = first.curves[c];
    const double reach = old[q].radius;
    std::array<double, 2> window{std::numeric_limits<double>::infinity(),
                                 -std::numeric_limits<double>::infinity()};
    auto at = [&](size_t v, double guess) {
      return section_through(curve.axis, point(v), guess, old[c].radius);
    };
    for (const Edge& e : edges) {
      auto a = static_cast<size_t>(e.a), b = static_cast<size_t>(e.b);
      if (result.path_of[a] != static_cast<int>(c)) std::swap(a, b);
      if (result.path_of[a] != static_cast<int>(c) || result.path_of[b] != static_cast<int>(q))
        continue;
      window = {std::min(window[0], position[a] - reach), std::max(window[1], position[a] + reach)};
    }
    const double middle = 0.5 * (window[0] + window[1]);
    // Distance from the parent's axis over its radius there; `middle` is a guess for points of the
    // branch.
    auto ratio = [&](size_t v, double guess) {
      const double u = at(v, guess);
      return (point(v) - curve.axis(u)).norm() / std::max(curve.radius(u)[0], 0.25 * old[c].radius);
    };
    // Moves the border from both sides across edges until nothing changes, usually by a few rows.
    for (bool changed = true; changed;) {
      changed = false;
      for (const Edge& e : edges) {
        auto a = static_cast<size_t>(e.a), b = static_cast<size_t>(e.b);
        if (result.path_of[a] != static_cast<int>(c)) std::swap(a, b);
        if (result.path_of[a] != static_cast<int>(c) || result.path_of[b] != static_cast<int>(q))
          continue;
        if (position[a] < window[0] || position[a] > window[1]) continue;
        if (ratio(a, position[a]) > outside_tube) {
          result.path_of[a] = static_cast<int>(q);
          changed = true;
        }
      }
    }
    if (old[q].stub) continue;
    for (bool changed = true; changed;) {
      changed = false;
      for (const Edge& e : edges) {
        auto a = static_cast<size_t>(e.a), b = static_cast<size_t>(e.b);
        if (result.path_of[a] != static_cast<int>(c)) std::swap(a, b);
        if (result.path_of[a] != static_cast<int>(c) || result.path_of[b] != static_cast<int>(q))
          continue;
        if (first.paths.path_of[b] == static_cast<int>(q) && ratio(b, middle) < inside_tube) {
          result.path_of[b] = static_cast<int>(c);
          position[b] = at(b, middle);
          changed = true;
        }
      }
    }
  }

  for (size_t k = 0; k < old.size(); ++k) {
    AxisPath& path = result.paths[k];
    path.vertices.clear();
    path.u.clear();
    Vec3 foot = Vec3::Zero(), along = Vec3::Zero();
    const Vec3& center = centers[static_cast<size_t>(path.end)];
    if (old[k].stub) {  // a straight axis from the closest point of its parent's
      const auto c = static_cast<size_t>(path.parent);
      foot = old[c].stub ? center
                         : first.curves[c].axis(
                               closest_parameter(first.curves[c].axis, center, old[c].radius));
      along = (center - foot).normalized();
      path.foot = foot;
    }
    path.start = 0;
    path.finish = old[k].stub ? (center - foot).norm() : first.curves[k].axis.end;
    for (size_t v = 0; v < n; ++v) {
      if (result.path_of[v] != static_cast<int>(k)) continue;
      path.vertices.push_back(static_cast<int>(v));
      if (old[k].stub)
        path.u.push_back((point(v) - foot).dot(along));
      else
        path.u.push_back(first.paths.path_of[v] == static_cast<int>(k)
                             ? first.position[v]
                             : closest_parameter(first.curves[k].axis, point(v), old[k].radius));
    }
    path.stub = false;
  }
  return result;
}

}  // namespace vasorod
