#include "surgery/drawn_ellipse.h"

#include <algorithm>
#include <cmath>

#include <vasorod/error.h>

#include "data/index.h"
#include "data/sentence.h"
#include "geometry/flat_chart.h"

namespace vasorod {
namespace {

// How far the unrolled patch goes around the vessel, radians: never so far that it could close.
constexpr double largest_angle = 2 * M_PI / 3;
// An ellipse that keeps this many mean edges from an end or a fork is clear of it.
constexpr double clearance = 1.5;

}  // namespace

DrawnEllipse::DrawnEllipse(const TriangleSurface& surface, const RodTree& rod,
                           const Binding& binding, const IncisionPlace& place, double length,
                           double width)
    : surface_(surface),
      rod_(rod),
      binding_(binding),
      place_(place),
      edges_(edges_of(surface.triangles)),
      half_length_(length / 2),
      half_width_(width / 2),
      edge_(mean_edge_length(surface)),
      at_end_(index(surface.points.rows()), 0) {
  for (const Edge& e : edges_)
    if (e.boundary()) at_end_[index(e.a)] = at_end_[index(e.b)] = 1;
  // The patch grows until the ellipse lies inside it.
  constexpr double growth = 1.3;
  double along = half_length_ + 3 * edge_;
  double angle = std::min(largest_angle, (half_width_ + 3 * edge_) / direction_at_pick().norm());
  for (int round = 0; round < 8; ++round, along *= growth) {
    draw(along, angle);
    if (obstacle() || !cut_off()) return;
    angle = std::min(largest_angle, angle * growth);
  }
  throw InputError(place_.where + ": an ellipse " + size_text() +
                   " goes too far around the vessel, expected a narrower one");
}

std::string DrawnEllipse::size_text(double scale) const {
  const auto text = [&](double x) {
    return scale < 1 ? rounded_down(scale * x) : number_text(x, 4);
  };
  return text(2 * half_length_) + " long and " + text(2 * half_width_) + " wide";
}

std::vector<std::array<int, 2>> DrawnEllipse::crossing_edges() const {
  std::vector<std::array<int, 2>> crossing;
  for (const Edge& e : edges_)
    if ((value_[index(e.a)] < 0) != (value_[index(e.b)] < 0)) crossing.push_back({e.a, e.b});
  return crossing;
}

void DrawnEllipse::require_room() const {
  const auto met = obstacle();
  if (!met) return;
  double fits = 1;
  for (int v = 0; v < chart_.rows(); ++v) {
    if (!is_obstacle(v)) continue;
    const double away = chart_.row(v).norm();
    fits = std::min(fits, size_at(v) * (1 - clearance * edge_ / std::max(away, edge_)));
  }
  throw InputError(place_.where + ": an ellipse " + size_text() + " runs into " +
                   (at_end_[index(*met)] ? "an open end" : "a fork") + " of the vessel near " +
                   place_text(surface_.points.row(*met)) +
                   (2 * fits * std::min(half_length_, half_width_) < smallest_ellipse * edge_
                        ? ", expected a pick farther from it"
                        : ", expected one of at most " + size_text(fits)));
}

Vec2 DrawnEllipse::direction_at_pick() const {
  Vec2 sum = Vec2::Zero();
  for (int k = 0; k < 3; ++k)
    sum += place_.hit.barycentric[k] * direction(surface_.triangles(place_.hit.triangle, k));
  return sum;
}

bool DrawnEllipse::in_patch(int v) const {
  return !std::isnan(chart_(v, 0));
}

// A vertex of the patch at an open end or beside a fork.
bool DrawnEllipse::is_obstacle(int v) const {
  return in_patch(v) && (at_end_[index(v)] || at_fork_[index(v)]);
}

// The factor by which the ellipse would have to grow to go through the vertex.
double DrawnEllipse::size_at(int v) const {
  return std::hypot(chart_(v, 0) / half_length_, chart_(v, 1) / half_width_);
}

// The connected triangles around the pick within `along` of it along the rod and `angle` around.
std::vector<int> DrawnEllipse::patch(double along, double angle) {
  const Eigen::VectorXd s = arc_length(rod_, binding_);
  const Vec2 there = direction_at_pick().normalized();
  double s0 = 0;
  for (int k = 0; k < 3; ++k)
    s0 += place_.hit.barycentric[k] * s[surface_.triangles(place_.hit.triangle, k)];
  const auto near = [&](int v) {
    return std::abs(s[v] - s0) <= along &&
           direction(v).dot(there) >= std::cos(angle) * direction(v).norm();
  };
  std::vector<std::array<int, 3>> beside(index(surface_.triangles.rows()), {-1, -1, -1});
  for (const Edge& e : edges_) {
    if (e.boundary()) continue;
    for (const int side : {0, 1}) {
      auto& list = beside[index(e.triangle[index(side)])];
      *std::find(list.begin(), list.end(), -1) = e.triangle[index(1 - side)];
    }
  }
  at_fork_.assign(index(surface_.points.rows()), 0);
  std::vector<char> seen(beside.size(), 0);
  std::vector<int> patch{place_.hit.triangle};
  seen[index(place_.hit.triangle)] = 1;
  for (size_t i = 0; i < patch.size(); ++i)
    for (const int next : beside[index(patch[i])]) {
      if (next < 0 || seen[index(next)]) continue;
      bool taken = true, forks = false;
      for (int k = 0; k < 3; ++k) {
        const int v = surface_.triangles(next, k);
        forks = forks || !place_.allowed[index(v)];
        taken = taken && near(v);
      }
      if (forks) {  // the patch's corners beside it are where the ellipse meets the fork
        for (int k = 0; k < 3; ++k) at_fork_[index(surface_.triangles(next, k))] = 1;
        continue;
      }
      if (!taken) continue;
      seen[index(next)] = 1;
      patch.push_back(next);
    }
  return patch;
}

void DrawnEllipse::draw(double along, double angle) {
  ChartRequest request;
  request.patch = patch(along, angle);
  request.triangle = place_.hit.triangle;
  request.barycentric = place_.hit.barycentric;
  request.along.resize(static_cast<Eigen::Index>(request.patch.size()), 3);
  in_patch_.assign(index(surface_.triangles.rows()), 0);
  for (size_t i = 0; i < request.patch.size(); ++i) {
    in_patch_[index(request.patch[i])] = 1;
    Vec3 axis = Vec3::Zero();
    for (int k = 0; k < 3; ++k) {
      const RodCoordinates& at = binding_[index(surface_.triangles(request.patch[i], k))];
      axis += frame_at(rod_, rod_.rest, at.element, at.s).director(3);
    }
    request.along.row(static_cast<Eigen::Index>(i)) = axis.transpose();
  }
  chart_ = unroll(surface_, request);
  // About the distance from the ellipse; off the patch it only has to be outside.
  value_.assign(index(surface_.points.rows()), half_length_);
  for (int v = 0; v < chart_.rows(); ++v) {
    if (!in_patch(v)) continue;
    const double size = size_at(v);
    const double slope = std::hypot(chart_(v, 0) / (half_length_ * half_length_),
                                    chart_(v, 1) / (half_width_ * half_width_));
    value_[index(v)] = slope > 0 ? size * (size - 1) / slope : -std::min(half_length_, half_width_);
  }
}

// A vertex at an end or a fork inside the ellipse or on an edge that its rim crosses.
std::optional<int> DrawnEllipse::obstacle() const {
  std::optional<int> met;
  const auto look_at = [&](int v) {
    if (!is_obstacle(v)) return;
    if (!met || size_at(v) < size_at(*met)) met = v;
  };
  for (int v = 0; v < chart_.rows(); ++v)
    if (value_[index(v)] < 0) look_at(v);
  for (const auto& edge : crossing_edges())
    for (const int v : edge) look_at(v);
  return met;
}

// Whether the patch ends within the ellipse or on an edge that its rim crosses.
bool DrawnEllipse::cut_off() const {
  const auto has = [&](int t) { return t >= 0 && in_patch_[index(t)] != 0; };
  return std::any_of(edges_.begin(), edges_.end(), [&](const Edge& e) {
    return has(e.triangle[0]) != has(e.triangle[1]) &&
           (value_[index(e.a)] < 0 || value_[index(e.b)] < 0);
  });
}

}  // namespace vasorod
