#include "vessel/centerline.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "vessel/arc_length.h"

namespace vasorod {
namespace {

constexpr double knot_spacing = 0.5;  // of the radius
constexpr double cut_off = 4.0;       // wavelength over radius at which full smoothing halves an undulation
constexpr double rough = 0.02;        // deviation from round over radius from which smoothing is full
constexpr double least = 1e-4;        // share of full smoothing kept on a perfectly round wall
constexpr double ramp = 0.3;          // width over radius in which whole sections beside broken ones fade in
constexpr int rounds = 6;

using Interval = std::array<double, 2>;

// The parameter u near `u` with (p - r(u)) . r'(u) = 0: the section through p.
double section_through(const Spline<3>& axis, const Vec3& p, double u, double radius) {
  for (int k = 0; k < 4; ++k) {
    const Vec3 d = p - axis(u), t = axis.derivative(u);
    const double slope = std::max(t.squaredNorm() - d.dot(axis.second(u)), 0.1 * t.squaredNorm());
    u += std::clamp(d.dot(t) / slope, -radius, radius);
  }
  return u;
}

// 0 inside the interval, rising to 1 outside it: vertices of one section get one weight, whatever the
// round-off in their positions, and no vertex counts whose section is broken, for it would pull the axis
// further to its side.
double outside(double u, const Interval& interval, double width) {
  return std::clamp(std::max(interval[0] - u, u - interval[1]) / width, 0.0, 1.0);
}

// Penalty that halves undulations of wavelength cut_off * radius when every section is whole.
double penalty_for(double interval_weight, double step, double radius, int order) {
  return interval_weight / std::pow(2 * std::sin(M_PI * step / (cut_off * radius)), 2 * order);
}

class PathFit {
 public:
  PathFit(const TriangleSurface& surface, const Eigen::VectorXd& area, const AxisPath& path)
      : surface_(surface), path_(path), u_(path.u) {
    for (const int v : path.vertices) share_.push_back(area[v]);
    curve.parent = path.parent;
    curve.end = path.end;
    start_ = path.start;
    end_ = path.finish;
  }

  AxisCurve curve;
  std::optional<Vec3> first;  // where the axis begins
  Vec3 last = Vec3::Zero();   // where it ends
  std::vector<Interval> broken;

  double radius() const { return path_.radius; }
  void add_triangle(const std::array<size_t, 3>& triangle) { triangles_.push_back(triangle); }
  // Finds every vertex' section, its direction in it, and the share of directions times length it stands for.
  void project() {
    for (size_t i = 0; i < u_.size(); ++i)
      u_[i] = section_through(curve.axis, point(path_.vertices[i]), u_[i], radius());
    const std::vector<double> angle = directions();
    share_.assign(u_.size(), 0);
    for (const auto& t : triangles_) {
      const double s1 = u_[t[1]] - u_[t[0]], s2 = u_[t[2]] - u_[t[0]];
      const double a1 = std::remainder(angle[t[1]] - angle[t[0]], 2 * M_PI);
      const double a2 = std::remainder(angle[t[2]] - angle[t[0]], 2 * M_PI);
      const double third = radius() * (a1 * s2 - a2 * s1) / 6;
      for (const size_t i : t) share_[i] += third;
    }
  }
  double at(const Vec3& p, double guess) const { return section_through(curve.axis, p, guess, radius()); }
  double u(size_t i) const { return u_[i]; }

  // Smooths the vertices of whole sections. The new axis is parametrised by the arc length of the present
  // one, counted such that its whole sections begin at `clean_at` (a branch: how far they are from its
  // parent's axis). `correct`: smooth the data plus what the present axis leaves of them, which undoes the
  // smoothing's pull on a bend (Tukey's twicing).
  void fit_axis(bool correct, double smoothing, std::optional<double> clean_at = {}) {
    const Spline<3> present = curve.axis;
    std::vector<double> weights(u_.size());
    for (size_t i = 0; i < u_.size(); ++i) weights[i] = weight(i);
    std::vector<double> before = u_;
    if (!present.control.empty()) {
      const ArcLength arc(present);
      const double offset = clean_at ? *clean_at - arc(curve.clean_start) : 0;
      for (double& u : u_) u = arc(u) + offset;
      end_ = arc(present.end) + offset;
      if (clean_at || first) start_ = 0;
      curve.clean_start = arc(curve.clean_start) + offset;
    }
    Spline<3> axis;
    axis.start = start_;
    axis.end = end_;
    axis.intervals =
        std::max(3, static_cast<int>(std::ceil((end_ - start_) / (knot_spacing * radius()) - 1e-6)));
    const double share = 2 * M_PI * radius() * axis.step();
    std::vector<SplineDatum<3>> data;
    data.reserve(u_.size() + 2);
    // What is smoothed: the value itself, or twice the value less the present axis there.
    auto add = [&](double u, double u_before, double w, const Vec3& value) {
      data.push_back({u, w, correct ? Vec3(2 * value - present(u_before)) : value});
    };
    for (size_t i = 0; i < u_.size(); ++i)
      if (weights[i] > 0) add(u_[i], before[i], weights[i], point(path_.vertices[i]));
    // An end's centre counts as much as half a radius of whole sections: alone it decides where an oblique
    // end breaks the sections, and its noise is averaged out where it does not.
    const double end_weight = M_PI * radius() * radius();
    if (first) data.push_back({axis.start, end_weight, *first});
    add(axis.end, present.end, end_weight, last);
    // The second difference decides only where no data do.
    fit_penalised(axis, data, {1e-6 * share, smoothing * penalty_for(share, axis.step(), radius(), 3)});
    curve.axis = std::move(axis);
  }

  void fit_radius() {
    curve.radius.start = curve.axis.start;
    curve.radius.end = curve.axis.end;
    curve.radius.intervals = curve.axis.intervals;
    const double share = 2 * M_PI * radius() * curve.axis.step();
    std::vector<SplineDatum<1>> data;
    data.reserve(u_.size());
    for (size_t i = 0; i < u_.size(); ++i) {
      SplineDatum<1> d{u_[i], weight(i), {}};
      d.value[0] = (point(path_.vertices[i]) - curve.axis(u_[i])).norm();
      if (d.weight > 0) data.push_back(d);
    }
    if (data.empty()) data.push_back({curve.axis.end, share, Eigen::Matrix<double, 1, 1>(radius())});
    fit_penalised(curve.radius, data, {penalty_for(share, curve.axis.step(), radius(), 2), 0});
  }

  // How far the wall is from round: RMS of distance from the axis minus radius, over the radius.
  double roughness() const {
    double sum = 0, total = 0;
    for (size_t i = 0; i < u_.size(); ++i) {
      const double w = weight(i);
      if (w == 0) continue;
      const double off = (point(path_.vertices[i]) - curve.axis(u_[i])).norm() - curve.radius(u_[i])[0];
      sum += w * off * off;
      total += w;
    }
    return total > 0 ? std::sqrt(sum / total) / radius() : 1;
  }

 private:
  Vec3 point(int v) const { return surface_.points.row(v); }

  // What vertex i stands for; 0 where its section is broken.
  double weight(size_t i) const {
    double w = std::max(share_[i], 0.0);
    for (const Interval& interval : broken) w *= outside(u_[i], interval, ramp * radius());
    return w;
  }

  // Angle of every vertex about the axis, from frames that do not twist.
  std::vector<double> directions() const {
    const int samples = 2 * curve.axis.intervals;
    const double step = (curve.axis.end - curve.axis.start) / samples;
    std::vector<Mat3> frames(static_cast<size_t>(samples) + 1);
    for (int k = 0; k <= samples; ++k) {
      const Vec3 t = curve.axis.derivative(curve.axis.start + k * step).normalized();
      Mat3& frame = frames[static_cast<size_t>(k)];
      if (k == 0)  // any direction does that moves with the surface
        frame.col(0) = point(path_.vertices.front()) - curve.axis(curve.axis.start);
      else
        frame = frames[static_cast<size_t>(k) - 1];
      frame.col(0) = (frame.col(0) - frame.col(0).dot(t) * t).normalized();
      frame.col(1) = t.cross(frame.col(0));
      frame.col(2) = t;
    }
    std::vector<double> angle(u_.size());
    for (size_t i = 0; i < u_.size(); ++i) {
      const Vec3 rho = point(path_.vertices[i]) - curve.axis(u_[i]),
                 t = curve.axis.derivative(u_[i]).normalized();
      const auto k =
          static_cast<size_t>(std::clamp(std::round((u_[i] - curve.axis.start) / step), 0.0, samples * 1.0));
      const Vec3 d1 = (frames[k].col(0) - frames[k].col(0).dot(t) * t).normalized();
      angle[i] = std::atan2(rho.dot(t.cross(d1)), rho.dot(d1));
    }
    return angle;
  }

  const TriangleSurface& surface_;
  const AxisPath& path_;
  std::vector<std::array<size_t, 3>> triangles_;  // those inside the path, indices into its vertices
  std::vector<double> u_, share_;
  double start_ = 0, end_ = 0;  // domain of the next fit
};

// Edges between a path and others, as (index of the path's vertex in its list, the other's vertex).
struct Contact {
  int other;
  std::vector<std::pair<size_t, int>> pairs;
};

std::vector<std::vector<Contact>> contacts_of(const std::vector<Edge>& edges, const AxisPaths& paths,
                                              const std::vector<size_t>& index) {
  std::vector<std::vector<Contact>> contacts(paths.paths.size());
  auto add = [&](int v, int w) {
    auto& list = contacts[static_cast<size_t>(paths.path_of[static_cast<size_t>(v)])];
    const int other = paths.path_of[static_cast<size_t>(w)];
    auto found = std::find_if(list.begin(), list.end(), [&](const Contact& c) { return c.other == other; });
    if (found == list.end()) found = list.insert(list.end(), {other, {}});
    found->pairs.emplace_back(index[static_cast<size_t>(v)], w);
  };
  for (const Edge& e : edges) {
    if (paths.path_of[static_cast<size_t>(e.a)] == paths.path_of[static_cast<size_t>(e.b)]) continue;
    add(e.a, e.b);
    add(e.b, e.a);
  }
  return contacts;
}

// The parameter in `window` at which `axis` comes closest to the line through p along t.
double closest_to_line(const Spline<3>& axis, const Vec3& p, const Vec3& t, const Interval& window) {
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
          const std::vector<std::vector<int>>& loops, const Eigen::VectorXd& area, const AxisPaths& paths,
          const std::vector<Vec3>& centers)
      : surface_(surface), loops_(loops), paths_(paths) {
    std::vector<size_t> index(paths.path_of.size(), 0);
    for (const AxisPath& path : paths.paths)
      for (size_t i = 0; i < path.vertices.size(); ++i) index[static_cast<size_t>(path.vertices[i])] = i;
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

  void run() {
    std::vector<double> smoothing(fits.size(), 1);
    for (PathFit& fit : fits) fit.fit_axis(false, 1);
    for (int round = 0; round < rounds; ++round) {
      for (PathFit& fit : fits) fit.project();
      for (size_t k = 0; k < fits.size(); ++k) find_broken(k);
      if (round > 0)
        for (size_t k = 0; k < fits.size(); ++k) {
          fits[k].fit_radius();
          smoothing[k] = std::clamp(std::pow(fits[k].roughness() / rough, 2), least, 1.0);
        }
      for (size_t k = 0; k < fits.size(); ++k) {
        std::optional<double> clean_at;
        if (fits[k].curve.parent >= 0) clean_at = attach(k);
        fits[k].fit_axis(round + 1 == rounds, smoothing[k], clean_at);
      }
    }
    for (PathFit& fit : fits) {
      fit.project();
      fit.fit_radius();
      fit.curve.first = fit.curve.axis.start;
      if (fit.curve.parent < 0) fit.curve.first = fit.at(*fit.first, fit.curve.axis.start);
      fit.curve.last = fit.at(fit.last, fit.curve.axis.end);
    }
  }

 private:
  Interval range_on(size_t k, const std::vector<int>& vertices, double guess) const {
    Interval range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    for (const int v : vertices) {
      const double u = fits[k].at(surface_.points.row(v), guess);
      range = {std::min(range[0], u), std::max(range[1], u)};
    }
    return range;
  }

  // Where the sections of path k are not whole: beyond the innermost point of an end, and where paths meet.
  void find_broken(size_t k) {
    PathFit& fit = fits[k];
    constexpr double far = std::numeric_limits<double>::infinity();
    fit.broken.clear();
    fit.curve.forks.clear();
    if (fit.curve.parent < 0) fit.broken.push_back({-far, range_on(k, loops_[0], fit.curve.axis.start)[1]});
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
        // Upstream of the border the wall already widens towards the branch, by about the branch's radius.
        fit.curve.forks.push_back(range);
        fit.broken.push_back({range[0] - other.radius(), range[1] + 0.3 * other.radius()});
      } else {
        own_start = std::max(own_start, range[1] + 0.3 * fit.radius());
      }
    }
    if (fit.curve.parent >= 0) {
      own_start = std::min(own_start, fit.curve.axis.end - 0.5 * fit.radius());
      fit.curve.clean_start = own_start;
      fit.broken.push_back({-far, own_start});
    }
  }

  // Lets path k begin on its parent's axis, where its own axis prolonged straight comes closest. Returns the
  // distance from there to its first whole section.
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
      window = {std::max(window[0], low - parent.radius()), std::min(window[1], high + parent.radius())};
    }
    const Vec3 whole = fit.curve.axis(fit.curve.clean_start);
    const Vec3 tangent = fit.curve.axis.derivative(fit.curve.clean_start).normalized();
    fit.curve.parent_u = closest_to_line(parent.curve.axis, whole, tangent, window);
    fit.first = parent.curve.axis(fit.curve.parent_u);
    return (whole - *fit.first).norm();
  }

  const TriangleSurface& surface_;
  const std::vector<std::vector<int>>& loops_;
  const AxisPaths& paths_;
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
  Centerline result;
  result.paths = axis_paths(surface, area, flow_tree(surface, edges, loops), loops, centers);
  TreeFit tree(surface, edges, loops, area, result.paths, centers);
  tree.run();
  result.position.assign(static_cast<size_t>(surface.points.rows()), 0);
  for (size_t k = 0; k < tree.fits.size(); ++k) {
    const std::vector<int>& vertices = result.paths.paths[k].vertices;
    for (size_t i = 0; i < vertices.size(); ++i)
      result.position[static_cast<size_t>(vertices[i])] = tree.fits[k].u(i);
    result.curves.push_back(std::move(tree.fits[k].curve));
  }
  return result;
}

}  // namespace vasorod
