#include "vessel/centerline.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "vessel/fork_border.h"
#include "vessel/path_fit.h"

namespace vasorod {
namespace {

constexpr double rough = 0.02;  // deviation from round over radius from which smoothing is full
constexpr double least = 1e-4;  // share of full smoothing kept on a perfectly round wall

using Interval = std::array<double, 2>;

// Edges between a path and others, as (index of the path's vertex in its list, the other's vertex).
struct Contact {
  int other;
  std::vector<std::pair<size_t, int>> pairs;
};

std::vector<std::vector<Contact>> contacts_of(const std::vector<Edge>& edges,
                                              const AxisPaths& paths,
                                              const std::vector<size_t>& index) {
  std::vector<std::vector<Contact>> contacts(paths.paths.size());
  auto add = [&](int v, int w) {
    auto& list = contacts[static_cast<size_t>(paths.path_of[static_cast<size_t>(v)])];
    const int other = paths.path_of[static_cast<size_t>(w)];
    auto found =
        std::find_if(list.begin(), list.end(), [&](const Contact& c) { return c.other == other; });
    if (found == list.end()) found = list.insert(list.end(), {other, {}});
    found->pairs.emplace_back(index[static_cast<size_t>(v)], w);
  };
  for (const Edge& e : edges) {
    if (paths.path_of[static_cast<size_t>(e.a)] == paths.path_of[static_cast<size_t>(e.b)])
      continue;
    add(e.a, e.b);
    add(e.b, e.a);
  }
  return contacts;
}

// The parameter in `window` at which `axis` comes closest to the line through p along t.
double closest_to_line(const Spline<3>& axis, const Vec3& p, const Vec3& t,
                       const Interval& window) {
  auto off_line = [&](double u) {
    const Vec3 w = axis(u) - p;
    return Vec3(w - w.dot(t) * t);
  };
  auto slope = [&](double u) { return off_line(u).dot(axis.derivative(u)); };
  constexpr int samples = 64;
  auto sample = [&](int k) { return window[0] + (window[1] - window[0]) * k / samples; };
  int best = 0;
  for (int k = 1; k <= samples; ++k)
    if (off_line(sample(k)).squaredNorm() < off_line(sample(best)).squaredNorm()) best = k;
  double low = sample(std::max(best - 1, 0)), high = sample(std::min(best + 1, samples));
  if (slope(low) > 0 || slope(high) < 0) return sample(best);
  for (int k = 0; k < 60; ++k) {
    const double middle = 0.5 * (low + high);
    (slope(middle) < 0 ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

class TreeFit {
 public:
  TreeFit(const TriangleSurface& surface, const std::vector<Edge>& edges,
          const std::vector<std::vector<int>>& loops, const Eigen::VectorXd& area,
          const AxisPaths& paths, const std::vector<Vec3>& centers)
      : surface_(surface), loops_(loops), straight_(paths.paths.size(), 0) {
    std::vector<size_t> index(paths.path_of.size(), 0);
    for (const AxisPath& path : paths.paths)
      for (size_t i = 0; i < path.vertices.size(); ++i)
        index[static_cast<size_t>(path.vertices[i])] = i;
    contacts_ = contacts_of(edges, paths, index);
    fits.reserve(paths.paths.size());
    for (const AxisPath& path : paths.paths) {
      fits.emplace_back(surface, area, path);
      fits.back().last = centers[static_cast<size_t>(path.end)];
      if (path.parent < 0) fits.back().first = centers[0];
    }
    for (Eigen::Index t = 0; t < surface.triangles.rows(); ++t) {
      std::array<size_t, 3> v{};
      for (size_t k = 0; k < 3; ++k)
        v[k] = static_cast<size_t>(surface.triangles(t, static_cast<Eigen::Index>(k)));
      const int path = paths.path_of[v[0]];
      if (paths.path_of[v[1]] == path && paths.path_of[v[2]] == path)
        fits[static_cast<size_t>(path)].add_triangle({index[v[0]], index[v[1]], index[v[2]]});
    }
  }

  std::vector<PathFit> fits;

  void run(int rounds) {
    std::vector<double> smoothing(fits.size(), 1);
    std::vector<size_t> active;
    for (size_t k = 0; k < fits.size(); ++k)
      if (!fits[k].stub()) active.push_back(k);
    for (const size_t k : active) fits[k].fit_axis(false, 1);
    for (int round = 0; round < rounds; ++round) {
      for (const size_t k : active) fits[k].project();
      for (const size_t k : active) find_broken(k);
      if (round > 0)
        for (const size_t k : active) {
          fits[k].fit_radius();
          smoothing[k] = std::clamp(std::pow(fits[k].roughness() / rough, 2), least, 1.0);
        }
      for (const size_t k : active) {
        std::optional<double> clean_at;
        if (has_parent(k)) clean_at = attach(k);
        fits[k].fit_axis(round + 1 == rounds, smoothing[k], clean_at);
      }
    }
    for (const size_t k : active) {
      PathFit& fit = fits[k];
      fit.project();
      fit.fit_radius();
      fit.curve.first = fit.curve.axis.start;
      if (fit.curve.parent < 0) fit.curve.first = fit.at(*fit.first, fit.curve.axis.start);
      fit.curve.last = fit.at(fit.last, fit.curve.axis.end);
    }
  }

 private:
  // Whether path k begins on the axis of another path that is already fitted.
  bool has_parent(size_t k) const {
    const int parent = fits[k].curve.parent;
    return parent >= 0 && !fits[static_cast<size_t>(parent)].stub();
  }

  Interval range_on(size_t k, const std::vector<int>& vertices, double guess) const {
    Interval range{std::numeric_limits<double>::infinity(),
                   -std::numeric_limits<double>::infinity()};
    for (const int v : vertices) {
      const double u = fits[k].at(surface_.points.row(v), guess);
      range = {std::min(range[0], u), std::max(range[1], u)};
    }
    return range;
  }

  // Where the sections of path k are not closed: beyond the innermost point of an end, and where
  // paths meet.
  void find_broken(size_t k) {
    PathFit& fit = fits[k];
    constexpr double far = std::numeric_limits<double>::infinity();
    fit.broken.clear();
    fit.curve.forks.clear();
    if (fit.curve.parent < 0)
      fit.broken.push_back({-far, range_on(k, loops_[0], fit.curve.axis.start)[1]});
    fit.broken.push_back(
        {range_on(k, loops_[static_cast<size_t>(fit.curve.end)], fit.curve.axis.end)[0], far});
    double own_start = fit.curve.axis.start;
    for (const Contact& contact : contacts_[k]) {
      Interval range{far, -far};
      for (const auto& [i, other] : contact.pairs) {
        const double u = fit.u(i), v = fit.at(surface_.points.row(other), u);
        range = {std::min({range[0], u, v}), std::max({range[1], u, v})};
      }
      const PathFit& other = fits[static_cast<size_t>(contact.other)];
      if (other.curve.parent == static_cast<int>(k)) {
        // Upstream of the border the wall already widens towards the branch, over about the
        // branch's radius.
        fit.curve.forks.push_back(range);
        fit.broken.push_back({range[0] - other.radius(), range[1] + 0.3 * other.radius()});
      } else {
        own_start = std::max(own_start, range[1] + 0.3 * fit.radius());
      }
    }
    if (fit.curve.parent >= 0) {
      // A branch too short for closed sections gets a straight axis.
      straight_[k] = own_start > fit.curve.axis.end - 0.5 * fit.radius() ? 1 : 0;
      fit.curve.clean_start = straight_[k] ? fit.curve.axis.end : own_start;
      fit.broken.push_back({-far, straight_[k] ? far : own_start});
    }
  }

  // Starts path k on its parent's axis, where the straight continuation of its own axis comes
  // closest (without closed sections: at the point closest to its end). Returns the distance from
  // there to its first closed section.
  double attach(size_t k) {
    PathFit& fit = fits[k];
    const PathFit& parent = fits[static_cast<size_t>(fit.curve.parent)];
    Interval window{parent.curve.axis.start, parent.curve.axis.end};
    for (const Contact& contact : contacts_[static_cast<size_t>(fit.curve.parent)]) {
      if (contact.other != static_cast<int>(k)) continue;
      double low = window[1], high = window[0];
      for (const auto& [i, other] : contact.pairs) {
        low = std::min(low, parent.u(i));
        high = std::max(high, parent.u(i));
      }
      window = {std::max(window[0], low - parent.radius()),
                std::min(window[1], high + parent.radius())};
    }
    if (straight_[k]) {
      fit.curve.parent_u = closest_parameter(parent.curve.axis, fit.last, parent.radius());
      fit.first = parent.curve.axis(fit.curve.parent_u);
      return (fit.last - *fit.first).norm();
    }
    const Vec3 whole = fit.curve.axis(fit.curve.clean_start);
    const Vec3 tangent = fit.curve.axis.derivative(fit.curve.clean_start).normalized();
    fit.curve.parent_u = closest_to_line(parent.curve.axis, whole, tangent, window);
    fit.first = parent.curve.axis(fit.curve.parent_u);
    return (whole - *fit.first).norm();
  }

  const TriangleSurface& surface_;
  const std::vector<std::vector<int>>& loops_;
  std::vector<char> straight_;  // per path: too short for closed sections
  std::vector<std::vector<Contact>> contacts_;
};

}  // namespace

Vec3 perimeter_centroid(const Points& points, const std::vector<int>& loop) {
  const Vec3 origin = points.row(loop.front());
  Vec3 sum = Vec3::Zero();
  double length = 0;
  for (size_t k = 0; k < loop.size(); ++k) {
    const Vec3 p = points.row(loop[k]).transpose() - origin;
    const Vec3 q = points.row(loop[(k + 1) % loop.size()]).transpose() - origin;
    sum += (q - p).norm() * 0.5 * (p + q);
    length += (q - p).norm();
  }
  return length > 0 ? Vec3(origin + sum / length) : origin;
}

Centerline fit_centerline(const TriangleSurface& surface, const std::vector<Edge>& edges,
                          const std::vector<std::vector<int>>& loops) {
  const Eigen::VectorXd area = vertex_areas(surface);
  std::vector<Vec3> centers;
  centers.reserve(loops.size());
  for (const auto& loop : loops) centers.push_back(perimeter_centroid(surface.points, loop));
  auto fitted = [&](AxisPaths paths, int rounds) {
    Centerline result;
    result.paths = std::move(paths);
    TreeFit tree(surface, edges, loops, area, result.paths, centers);
    tree.run(rounds);
    result.position.assign(static_cast<size_t>(surface.points.rows()), 0);
    for (size_t k = 0; k < tree.fits.size(); ++k) {
      const std::vector<int>& vertices = result.paths.paths[k].vertices;
      for (size_t i = 0; i < vertices.size(); ++i)
        result.position[static_cast<size_t>(vertices[i])] = tree.fits[k].u(i);
      result.curves.push_back(std::move(tree.fits[k].curve));
    }
    return result;
  };
  AxisPaths paths = axis_paths(surface, area, flow_tree(surface, edges, loops), loops, centers);
  if (paths.paths.size() > 1)
    paths = redraw_borders(surface, edges, fitted(std::move(paths), 3), centers);
  return fitted(std::move(paths), 6);
}

}  // namespace vasorod
