#include "wall/lumen.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "data/index.h"
#include "geometry/rigid_motion.h"
#include "geometry/triangle_surface.h"
#include "wall/plane_stress.h"

namespace vasorod {
namespace {

using Entries = std::vector<Eigen::Triplet<double>>;

Vec3 at(const Points& x, int vertex) {
  return x.row(vertex);
}

// Adds the lower triangle of a block that stands at (a, b); its transpose at (b, a) is implied.
void add_block(int a, int b, const Mat3& block, int first, Entries& entries) {
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const int row = first + 3 * a + i, column = first + 3 * b + j;
      if (a == b) {
        if (row >= column) entries.emplace_back(row, column, block(i, j));
      } else {
        entries.emplace_back(std::max(row, column), std::min(row, column), block(i, j));
      }
    }
}

// The tetrahedron of a triangle and the origin: det(x0, x1, x2) / 6. Adds `factor` times its
// gradient and returns it.
double add_tetrahedron_gradient(const Points& x, const std::array<int, 3>& v, double factor,
                                Points& g) {
  const std::array<Vec3, 3> p{at(x, v[0]), at(x, v[1]), at(x, v[2])};
  const Vec3 opposite = p[1].cross(p[2]) / 6;
  g.row(v[0]) += factor * opposite.transpose();
  g.row(v[1]) += factor / 6 * p[2].cross(p[0]).transpose();
  g.row(v[2]) += factor / 6 * p[0].cross(p[1]).transpose();
  return p[0].dot(opposite);
}

void add_tetrahedron_hessian(const Points& x, const std::array<int, 3>& v, double factor, int first,
                             Entries& entries) {
  for (size_t k = 0; k < 3; ++k)  // d/dx_l of x_l x x_m at the row of x_k
    add_block(v[k], v[(k + 1) % 3], factor / 6 * -hat(at(x, v[(k + 2) % 3])), first, entries);
}

// The triangles of a fan whose tip is the loop's first vertex. The fan looks out of the vessel,
// against the direction of the loop.
template <class Each>
void each_triangle(const LumenFan& fan, Each&& each) {
  for (size_t k = 1; k + 1 < fan.loop.size(); ++k)
    each(std::array<int, 3>{fan.loop[k + 1], fan.loop[k], fan.loop[0]});
}

// A fan with its tip c in the centroid: its volume is c . w / 6 with w = sum x_k+1 x x_k.
struct CentralFan {
  Vec3 tip = Vec3::Zero(), area2 = Vec3::Zero();

  CentralFan(const Points& x, const std::vector<int>& loop) {
    for (size_t k = 0; k < loop.size(); ++k) {
      tip += at(x, loop[k]) / static_cast<double>(loop.size());
      area2 += at(x, loop[(k + 1) % loop.size()]).cross(at(x, loop[k]));
    }
  }
};

int before(const std::vector<int>& loop, size_t k) {
  return loop[(k + loop.size() - 1) % loop.size()];
}
int after(const std::vector<int>& loop, size_t k) {
  return loop[(k + 1) % loop.size()];
}

// A triangle's area with its derivatives.
struct Area {
  double value = 0;
  Vec3 normal = Vec3::Zero();
  std::array<Vec3, 3> opposite;  // the edge opposite to each vertex
  double area2 = 0;

  Area(const Points& x, const std::array<int, 3>& v, double least) {
    for (size_t k = 0; k < 3; ++k) opposite[k] = at(x, v[(k + 2) % 3]) - at(x, v[(k + 1) % 3]);
    const Vec3 both = opposite[0].cross(opposite[1]);
    area2 = std::max(both.norm(), 2 * least);  // a triangle collapsed to a line has no normal
    normal = both / area2;
    value = area2 / 2;
  }
  Vec3 gradient(size_t k) const { return normal.cross(opposite[k]) / 2; }
  Mat3 hessian(size_t k, size_t l) const {
    const Mat3 across = Mat3::Identity() - normal * normal.transpose();
    Mat3 h = hat(opposite[k]).transpose() * across * hat(opposite[l]) / (2 * area2);
    if (l == (k + 1) % 3) h -= hat(normal) / 2;
    if (k == (l + 1) % 3) h += hat(normal) / 2;
    return h;
  }
};

constexpr double least_area = 1e-12;  // of a triangle, over its area at rest

std::array<int, 3> vertices(const Triangles& triangles, int t) {
  return {triangles(t, 0), triangles(t, 1), triangles(t, 2)};
}

}  // namespace

double thinning_exponent(const Material& m) {
  const Mat3 c = plane_stress(m);
  const double by_first = m.poisson_lt / m.young_axial,
               by_second = m.poisson_tt / m.young_transverse;
  return 1 - (by_first * (c(0, 0) + c(0, 1)) + by_second * (c(0, 1) + c(1, 1))) / 2;
}

Lumen::Lumen(const TriangleSurface& rest, const Eigen::VectorXd& depth, double thinning,
             std::vector<LumenFan> fans)
    : triangles_(rest.triangles),
      depth_(depth),
      tissue_(rest.triangles.rows()),
      rest_area_(triangle_areas(rest)),
      thinning_(thinning),
      fans_(std::move(fans)) {
  for (int t = 0; t < triangles_.rows(); ++t) {
    double mean = 0;
    for (int k = 0; k < 3; ++k) mean += depth[triangles_(t, k)] / 3;
    tissue_[t] = mean * rest_area_[t];
  }
}

double Lumen::volume(const Points& x) const {
  Points unused = Points::Zero(x.rows(), 3);
  return add_gradient(x, 0, unused);
}

double Lumen::add_gradient(const Points& x, double factor, Points& g) const {
  double volume = 0;
  for (int t = 0; t < triangles_.rows(); ++t) {
    const auto v = vertices(triangles_, t);
    volume += add_tetrahedron_gradient(x, v, factor, g);
    const Area area(x, v, least_area * rest_area_[t]);
    const double tissue = tissue_[t] * std::pow(area.value / rest_area_[t], thinning_);
    volume -= tissue;
    const double slope = factor * thinning_ * tissue / area.value;
    for (size_t k = 0; k < 3; ++k) g.row(v[k]) -= slope * area.gradient(k).transpose();
  }
  for (const LumenFan& fan : fans_) volume += add_fan_gradient(x, fan, factor, g);
  return volume;
}

Points Lumen::lid_force(const Points& x, int f) const {
  const LumenFan& fan = fans_[index(f)];
  Points force = Points::Zero(x.rows(), 3);
  const size_t n = fan.loop.size();
  const Vec3 tip = fan.from_first ? at(x, fan.loop[0]) : CentralFan(x, fan.loop).tip;
  Vec3 on_tip = Vec3::Zero();
  for (size_t k = 0; k < n; ++k) {
    const int a = after(fan.loop, k), b = fan.loop[k];
    const Vec3 third = (at(x, a) - tip).cross(at(x, b) - tip) / 6;
    force.row(a) += third.transpose();
    force.row(b) += third.transpose();
    on_tip += third;
  }
  if (fan.from_first) {
    force.row(fan.loop[0]) += on_tip.transpose();
    return force;
  }
  const Vec3 normal = on_tip.normalized();
  for (size_t k = 0; k < n; ++k) {
    const int a = fan.loop[k], b = after(fan.loop, k);
    const double ring = (at(x, b) - at(x, a)).norm() * (depth_[a] + depth_[b]) / 2;
    for (const int v : {a, b}) force.row(v) -= ring / 2 * normal.transpose();
    force.row(a) += on_tip.transpose() / static_cast<double>(n);
  }
  return force;
}

double Lumen::add_fan_gradient(const Points& x, const LumenFan& fan, double factor, Points& g) {
  if (fan.from_first) {
    double volume = 0;
    each_triangle(fan, [&](const std::array<int, 3>& v) {
      volume += add_tetrahedron_gradient(x, v, factor, g);
    });
    return volume;
  }
  const CentralFan central(x, fan.loop);
  const Vec3 by_tip = central.area2 / static_cast<double>(fan.loop.size());
  for (size_t k = 0; k < fan.loop.size(); ++k) {
    const Vec3 across = at(x, after(fan.loop, k)) - at(x, before(fan.loop, k));
    g.row(fan.loop[k]) += factor / 6 * (central.tip.cross(across) + by_tip).transpose();
  }
  return central.tip.dot(central.area2) / 6;
}

void Lumen::add_hessian(const Points& x, double factor, int first, Entries& entries) const {
  for (int t = 0; t < triangles_.rows(); ++t) {
    const auto v = vertices(triangles_, t);
    add_tetrahedron_hessian(x, v, factor, first, entries);
    if (thinning_ == 0) continue;
    const Area area(x, v, least_area * rest_area_[t]);
    const double slope = factor * thinning_ * tissue_[t] *
                         std::pow(area.value / rest_area_[t], thinning_) / area.value,
                 bend = slope * (thinning_ - 1) / area.value;
    for (size_t k = 0; k < 3; ++k)
      for (size_t l = 0; l <= k; ++l)
        add_block(
            v[k], v[l],
            -slope * area.hessian(k, l) - bend * area.gradient(k) * area.gradient(l).transpose(),
            first, entries);
  }
  for (const LumenFan& fan : fans_) {
    if (fan.from_first) {
      each_triangle(fan, [&](const std::array<int, 3>& v) {
        add_tetrahedron_hessian(x, v, factor, first, entries);
      });
      continue;
    }
    const CentralFan central(x, fan.loop);
    const size_t n = fan.loop.size();
    const double share = factor / (6 * static_cast<double>(n));
    std::vector<Mat3> turn;  // d w / d x_k
    for (size_t k = 0; k < n; ++k)
      turn.push_back(hat(at(x, after(fan.loop, k)) - at(x, before(fan.loop, k))));
    for (size_t k = 0; k < n; ++k)
      for (size_t l = 0; l <= k; ++l)
        add_block(fan.loop[k], fan.loop[l], share * (turn[l] + turn[k].transpose()), first,
                  entries);
    for (size_t k = 0; k < n; ++k)
      add_block(after(fan.loop, k), fan.loop[k], -factor / 6 * hat(central.tip), first, entries);
  }
}

}  // namespace vasorod
