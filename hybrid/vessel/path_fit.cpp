#include "vessel/path_fit.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include <vasorod/error.h>

#include "data/sentence.h"
#include "vessel/arc_length.h"

namespace vasorod {
namespace {

constexpr double knot_spacing = 0.5;  // of the radius
// Wavelength over radius at which full smoothing halves an undulation.
constexpr double cut_off = 4.0;
constexpr double most_radii = 50000;  // length of an axis
// Width over radius in which closed sections beside open ones fade in.
constexpr double ramp = 0.3;

using Interval = std::array<double, 2>;

// 0 inside the interval, increasing to 1 outside it. Vertices of one section get the same weight,
// whatever the round-off in their positions. Vertices of open sections have no weight: they would
// pull the axis to their side.
double outside(double u, const Interval& interval, double width) {
  return std::clamp(std::max(interval[0] - u, u - interval[1]) / width, 0.0, 1.0);
}

// Penalty that halves undulations of wavelength cut_off * radius if every section is closed.
double penalty_for(double interval_weight, double step, double radius, int order) {
  return interval_weight / std::pow(2 * std::sin(M_PI * step / (cut_off * radius)), 2 * order);
}

[[noreturn]] void refuse_without_axis() {
  throw InputError("found no axis through the surface's sections, expected a tubular vessel");
}

}  // namespace

double section_through(const Spline<3>& axis, const Vec3& p, double u, double radius) {
  for (int k = 0; k < 6; ++k) {
    const auto [position, tangent, bend] = axis.jet(u);
    const Vec3 d = p - position;
    const double least = 0.1 * tangent.squaredNorm(), slope = tangent.squaredNorm() - d.dot(bend);
    const double step = std::clamp(d.dot(tangent) / std::max(slope, least), -radius, radius);
    if (!std::isfinite(step)) break;  // the axis is a point there
    u += step;
    // Newton's next step is about as long as this one squared.
    if (std::abs(step) < (slope > least ? 1e-6 : 1e-10) * radius) break;
  }
  return u;
}

double closest_parameter(const Spline<3>& axis, const Vec3& p, double radius) {
  const int samples = std::max(4, static_cast<int>((axis.end - axis.start) / (0.25 * radius)));
  double best = axis.start, distance = std::numeric_limits<double>::infinity();
  for (int k = 0; k <= samples; ++k) {
    const double u = axis.start + (axis.end - axis.start) * k / samples;
    if ((axis(u) - p).norm() >= distance) continue;
    distance = (axis(u) - p).norm();
    best = u;
  }
  return std::clamp(section_through(axis, p, best, radius), axis.start, axis.end);
}

PathFit::PathFit(const TriangleSurface& surface, const Eigen::VectorXd& area, const AxisPath& path)
    : surface_(surface), path_(path), u_(path.u) {
  for (const int v : path.vertices) share_.push_back(area[v]);
  curve.parent = path.parent;
  curve.end = path.end;
  first = path.foot;
  start_ = path.start;
  end_ = path.finish;
}

void PathFit::project() {
  for (size_t i = 0; i < u_.size(); ++i)
    u_[i] = section_through(curve.axis, point(path_.vertices[i]), u_[i], radius());
  const std::vector<double> angle = directions();
  share_.assign(u_.size(), 0);
  // The difference of two angles from -pi to pi, which lies there too.
  const auto turned = [](double to, double from) {
    const double by = to - from;
    return std::abs(by) > M_PI ? by - std::copysign(2 * M_PI, by) : by;
  };
  for (const auto& t : triangles_) {
    const double s1 = u_[t[1]] - u_[t[0]], s2 = u_[t[2]] - u_[t[0]];
    const double a1 = turned(angle[t[1]], angle[t[0]]), a2 = turned(angle[t[2]], angle[t[0]]);
    const double third = radius() * (a1 * s2 - a2 * s1) / 6;
    for (const size_t i : t) share_[i] += third;
  }
}

void PathFit::fit_axis(bool correct, double smoothing, std::optional<double> clean_at) {
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
  check_length();
  Spline<3> axis;
  axis.start = start_;
  axis.end = end_;
  axis.intervals =
      std::max(3, static_cast<int>(std::ceil((end_ - start_) / (knot_spacing * radius()) - 1e-6)));
  const double share = 2 * M_PI * radius() * axis.step();
  std::vector<SplineDatum<3>> data;
  data.reserve(u_.size() + 2);
  // The data to smooth: the value itself, or twice the value minus the current axis there.
  auto add = [&](double u, double u_before, double w, const Vec3& value) {
    data.push_back({u, w, correct ? Vec3(2 * value - present(u_before)) : value});
  };
  for (size_t i = 0; i < u_.size(); ++i)
    if (weights[i] > 0) add(u_[i], before[i], weights[i], point(path_.vertices[i]));
  // The centre of an end weighs as much as half a radius of closed sections. Where an oblique end
  // opens the sections, the centre alone decides; elsewhere its noise is averaged out.
  const double end_weight = M_PI * radius() * radius();
  if (first) data.push_back({axis.start, end_weight, *first});
  add(axis.end, present.end, end_weight, last);
  // The second difference matters only where there are no data.
  fit_penalised(axis, data,
                {1e-6 * share, smoothing * penalty_for(share, axis.step(), radius(), 3)});
  // On steps of a thousandth of the radius the penalty hides the data.
  for (const Vec3& p : axis.control)
    if (!p.allFinite()) refuse_without_axis();
  curve.axis = std::move(axis);
}

// Paths along edges are longer than the axis that they surround. An axis much longer than these
// paths has lost its rows of vertices and would grow without bound.
void PathFit::check_length() const {
  // The sections of a flat ring have one centre: its axis shrinks to a point.
  if (!(end_ - start_ > 1e-6 * radius())) refuse_without_axis();
  const double on_edges = path_.finish - path_.start, longest = 2 * on_edges + 10 * radius();
  // Longer ones would be fitted for hours: a unit is wrong, or the mesh has a few long triangles.
  // Where the edges are not as long, rounding alone made the axis of a flat ring.
  if (end_ - start_ > most_radii * radius()) {
    if (longest < most_radii * radius()) refuse_without_axis();
    throw InputError("found an axis of length " + number_text(end_ - start_) + " on a radius of " +
                     number_text(radius()) + ", expected at most " + number_text(most_radii) +
                     " times the radius");
  }
  if (end_ - start_ > longest)
    throw InputError(
        "the axis cannot be found: it winds over " + std::to_string(end_ - start_) +
        " where the surface's edges take " + std::to_string(on_edges) +
        ", expected several rows of triangles per radius along the vessel (remesh: makes them)");
}

void PathFit::fit_radius() {
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
  // Without closed sections, the typical radius is used; next to data its weight is negligible.
  for (const double u : {curve.axis.start, curve.axis.end})
    data.push_back({u, 1e-9 * share, Eigen::Matrix<double, 1, 1>(radius())});
  fit_penalised(curve.radius, data, {penalty_for(share, curve.axis.step(), radius(), 2), 0});
}

double PathFit::roughness() const {
  double sum = 0, total = 0;
  for (size_t i = 0; i < u_.size(); ++i) {
    const double w = weight(i);
    if (w == 0) continue;
    const double off =
        (point(path_.vertices[i]) - curve.axis(u_[i])).norm() - curve.radius(u_[i])[0];
    sum += w * off * off;
    total += w;
  }
  return total > 0 ? std::sqrt(sum / total) / radius() : 1;
}

// The weight of vertex i; 0 where its section is open.
double PathFit::weight(size_t i) const {
  double w = std::max(share_[i], 0.0);
  for (const Interval& interval : broken) w *= outside(u_[i], interval, ramp * radius());
  return w;
}

// Angle of every vertex about the axis, in twist-free frames.
std::vector<double> PathFit::directions() const {
  const int samples = 2 * curve.axis.intervals;
  const double step = (curve.axis.end - curve.axis.start) / samples;
  std::vector<Mat3> frames(static_cast<size_t>(samples) + 1);
  for (int k = 0; k <= samples; ++k) {
    const Vec3 t = curve.axis.derivative(curve.axis.start + k * step).normalized();
    Mat3& frame = frames[static_cast<size_t>(k)];
    if (k == 0)  // any direction that moves with the surface
      frame.col(0) = point(path_.vertices.front()) - curve.axis(curve.axis.start);
    else
      frame = frames[static_cast<size_t>(k) - 1];
    frame.col(0) = (frame.col(0) - frame.col(0).dot(t) * t).normalized();
    frame.col(1) = t.cross(frame.col(0));
    frame.col(2) = t;
  }
  std::vector<double> angle(u_.size());
  for (size_t i = 0; i < u_.size(); ++i) {
    const auto [position, tangent, bend] = curve.axis.jet(u_[i]);
    const Vec3 rho = point(path_.vertices[i]) - position, t = tangent.normalized();
    const auto k = static_cast<size_t>(
        std::clamp(std::round((u_[i] - curve.axis.start) / step), 0.0, samples * 1.0));
    const Vec3 d1 = frames[k].col(0) - frames[k].col(0).dot(t) * t;  // of any length
    angle[i] = std::atan2(rho.dot(t.cross(d1)), rho.dot(d1));
  }
  return angle;
}

}  // namespace vasorod
