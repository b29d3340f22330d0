#include "sections/fit_sections.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include <vasorod/error.h>

#include "data/index.h"
#include "data/sentence.h"
#include "geometry/triangle_surface.h"
#include "sections/banded_cholesky.h"

namespace vasorod {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double turn = 2 * std::numbers::pi;
// Of the curvature along, beside the points. Where a space has more functions than the mesh has
// points, rounding errors of the points would else be the shape's waves between them; of a tube's
// curvature it takes less than a millionth.
constexpr double smoothing = 1e-6;

// u without its rounding errors: the vertices of a ring share the splines' values.
double same_ring(double u) {
  return std::ldexp(std::round(std::ldexp(u, 40)), -40);
}

// Values around a rim, periodic and linear between its vertices.
class AroundRim {
 public:
  void add(double angle, double value) { points_.emplace_back(wrapped(angle), value); }
  void sort() {
    std::sort(points_.begin(), points_.end());
    points_.emplace_back(points_.front().first + turn, points_.front().second);
  }
  double at(double angle) const {
    double a = wrapped(angle);
    if (a < points_.front().first) a += turn;
    const auto after = std::upper_bound(points_.begin(), points_.end(), std::pair(a, 1e300));
    if (after == points_.begin()) return points_.front().second;
    if (after == points_.end()) return points_.back().second;
    const auto before = std::prev(after);
    const double width = after->first - before->first;
    const double share = width > 0 ? (a - before->first) / width : 0;
    return (1 - share) * before->second + share * after->second;
  }

 private:
  static double wrapped(double angle) { return angle - turn * std::floor(angle / turn); }
  std::vector<std::pair<double, double>> points_;
};

// Triangles whose images (angle, u) are turned over fold the sections' star shape. A few of an
// uneven wall are within what the fit leaves; more are a wall that lies over itself.
constexpr double most_folded = 0.01;  // of the area

void require_star_shape(const Vessel& vessel, const SectionParameters& at,
                        const std::string& where) {
  const Triangles& triangles = vessel.surface.triangles;
  double all = 0, folded = 0, largest = 0;
  Vec3 place = Vec3::Zero();
  for (Eigen::Index t = 0; t < triangles.rows(); ++t) {
    const auto v = triangles.row(t);
    const auto apart = [&](int k) {
      const double d = at.angle[v[k]] - at.angle[v[0]];
      return Vec2(d - turn * std::round(d / turn), at.u[v[k]] - at.u[v[0]]);
    };
    const Vec2 first = apart(1), second = apart(2);
    const double area = triangle_normal(vessel.surface, static_cast<int>(t)).norm() / 2;
    all += area;
    if (first[0] * second[1] - first[1] * second[0] > 0) continue;
    folded += area;
    if (area <= largest) continue;
    largest = area;
    place = vessel.surface.points.row(v[0]);
  }
  if (folded <= most_folded * all) return;
  throw InputError(where +
                   "fidelity section: found a wall that lies over itself as seen from the "
                   "axis on " +
                   number_text(100 * folded / all, 2) + " % of its area, as at " +
                   place_text(place, 4) +
                   ", expected sections that are star-shaped about it: fidelity coupled takes any "
                   "surface");
}

}  // namespace

SectionParameters section_parameters(const Vessel& vessel, const std::string& where) {
  if (vessel.rod.branches.size() != 1)
    throw InputError(where + "fidelity section: found a vessel with " +
                     std::to_string(vessel.rod.branches.size()) +
                     " branches, expected one without a fork: fidelity coupled takes forks");
  const RodBranch& branch = vessel.rod.branches.front();
  std::vector<double> abscissa(vessel.rod.elements.size(), 0);
  double length = 0;
  for (const int e : branch.elements) {
    abscissa[index(e)] = length;
    length += vessel.rod.elements[index(e)].length;
  }
  const Eigen::Index count = vessel.surface.points.rows();
  SectionParameters at{VectorXd(count), VectorXd(count), {}};
  for (Eigen::Index i = 0; i < count; ++i) {
    const RodCoordinates& c = vessel.binding[index(i)];
    // z: beyond the ends of the rod.
    at.u[i] = abscissa[index(c.element)] + c.s + c.local.z();
    at.angle[i] = std::atan2(c.local.y(), c.local.x());
  }
  std::array<AroundRim, 2> rims;
  for (size_t e = 0; e < vessel.ends.size(); ++e) {
    const size_t side = vessel.ends[e].node == branch.nodes.front() ? 0 : 1;
    at.end[side] = static_cast<int>(e);
    for (const int v : vessel.ends[e].loop) rims[side].add(at.angle[v], at.u[v]);
    rims[side].sort();
  }
  for (Eigen::Index i = 0; i < count; ++i) {
    const double from = rims[0].at(at.angle[i]), to = rims[1].at(at.angle[i]);
    if (!(to > from))
      throw InputError(where +
                       "fidelity section: found rims that lie beside each other along the "
                       "axis, expected one beyond the other: fidelity coupled takes any surface");
    at.u[i] = same_ring(std::clamp((at.u[i] - from) / (to - from), 0.0, 1.0));
  }
  require_star_shape(vessel, at, where);
  return at;
}

SectionShape fit_sections(const SectionSpace& space, const SectionParameters& at,
                          const Points& points) {
  const int modes = space.modes(), functions = space.along.degree() + 1, rows = space.along.count();
  const MatrixXd around = harmonic_values(at.angle, space.harmonics, 0);
  BandMatrix normal(rows * modes, functions * modes - 1);
  MatrixXd right = MatrixXd::Zero(rows * modes, 3);
  for (Eigen::Index p = 0; p < points.rows();) {
    MatrixXd square = MatrixXd::Zero(modes, modes), sum = MatrixXd::Zero(modes, 3);
    const double u = at.u[p];
    for (; p < points.rows() && at.u[p] == u; ++p) {
      square.noalias() += around.row(p).transpose() * around.row(p);
      sum.noalias() += around.row(p).transpose() * points.row(p);
    }
    const AxialBasis::Values basis = space.along.at(u);
    for (int j = 0; j < functions; ++j) {
      right.middleRows((basis.first + j) * modes, modes) += basis.values(0, j) * sum;
      for (int i = j; i < functions; ++i)
        normal.add((basis.first + i) * modes, (basis.first + j) * modes,
                   basis.values(0, i) * basis.values(0, j) * square);
    }
  }
  const double per_span = static_cast<double>(points.rows()) / space.along.spans();
  for (int span = 0; span < space.along.spans(); ++span) {
    const double middle = (space.along.begin(span) + space.along.end(span)) / 2,
                 size = space.along.end(span) - space.along.begin(span);
    const AxialBasis::Values basis = space.along.at(middle, span);
    for (int j = 0; j < functions; ++j)
      for (int i = j; i < functions; ++i)
        for (int m = 0; m < modes; ++m)
          normal.lower((basis.first + i) * modes + m, (basis.first + j) * modes + m) +=
              smoothing * per_span * std::pow(size, 4) * basis.values(2, i) * basis.values(2, j);
  }
  // Harmonics that the mesh cannot tell apart stay at zero.
  normal.add_to_diagonal(VectorXd::Constant(rows * modes, 1e-13 * per_span));
  normal.factorise();
  normal.solve(right);
  SectionShape shape{space, MatrixXd(space.row_size(), rows)};
  for (int i = 0; i < rows; ++i)
    shape.coefficients.col(i) = right.middleRows(i * modes, modes).reshaped();
  return shape;
}

Points points_of(const SectionShape& shape, const SectionParameters& at) {
  const MatrixXd around = harmonic_values(at.angle, shape.space.harmonics, 0);
  Points points(at.u.size(), 3);
  VectorXd section;
  for (Eigen::Index p = 0; p < points.rows(); ++p) {
    if (p == 0 || at.u[p] != at.u[p - 1]) {
      const AxialBasis::Values basis = shape.space.along.at(at.u[p]);
      section = shape.coefficients.middleCols(basis.first, basis.values.cols()) *
                basis.values.row(0).transpose();
    }
    points.row(p) = around.row(p) * section.reshaped(shape.space.modes(), 3);
  }
  return points;
}

}  // namespace vasorod
