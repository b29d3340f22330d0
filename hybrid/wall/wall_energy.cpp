#include "wall/wall_energy.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "wall/membrane_strain.h"

namespace vasorod {

WallPart WallEnergy::part(const std::vector<char>& vertices) const {
  const auto marked = [&](int v) { return v >= 0 && vertices[static_cast<size_t>(v)]; };
  WallPart part;
  std::vector<char> seen(sides_.size(), 0), edge(edges_.size(), 0);
  for (size_t t = 0; t < sides_.size(); ++t) {
    bool depends = false;
    for (int k = 0; k < 3; ++k)
      depends |= marked(triangles_(static_cast<int>(t), k)) ||
                 marked(sides_[t].neighbour[static_cast<size_t>(k)]);
    if (!depends) continue;
    part.triangles.push_back(static_cast<int>(t));
    seen[t] = 1;
    for (const int e : sides_[t].edge) {
      edge[static_cast<size_t>(e)] = 1;
      for (const int across : edge_triangle_[static_cast<size_t>(e)])
        if (across >= 0) seen[static_cast<size_t>(across)] = 1;
    }
  }
  for (size_t t = 0; t < seen.size(); ++t)
    if (seen[t]) part.seen.push_back(static_cast<int>(t));
  for (size_t e = 0; e < edge.size(); ++e)
    if (edge[e]) part.edges.push_back(static_cast<int>(e));
  return part;
}

WallEnergy::Geometry WallEnergy::geometry(const Eigen::VectorXd& q, const WallPart& part) const {
  Geometry g;
  const auto triangle_count = static_cast<size_t>(triangles_.rows());
  g.normal.resize(triangle_count);
  g.area2.resize(triangle_count);
  for (const int triangle : part.seen) {
    const auto t = static_cast<size_t>(triangle);
    const auto v = triangles_.row(triangle);
    const Vec3 x0 = point(q, v[0]);
    const Vec3 area = (point(q, v[1]) - x0).cross(point(q, v[2]) - x0);
    // A triangle collapsed to a line has no normal; any finite one keeps the energy finite.
    g.area2[t] = std::max(area.norm(), 1e-12 * triangle_rest_[t].area);
    g.normal[t] = area / g.area2[t];
  }
  g.half_sine.assign(edges_.size(), 0);
  g.half_cosine.assign(edges_.size(), 1);
  for (const int edge : part.edges) {
    const auto e = static_cast<size_t>(edge);
    if (edges_[e].rim) continue;
    const Vec3& n0 = g.normal[static_cast<size_t>(edge_triangle_[e][0])];
    const Vec3& n1 = g.normal[static_cast<size_t>(edge_triangle_[e][1])];
    // Side 0 traverses the edge from the lower vertex to the higher: n0 x n1 along the edge is
    // convex.
    const Vec3 along = point(q, edges_[e].b) - point(q, edges_[e].a);
    g.half_sine[e] = std::copysign((n1 - n0).norm() / 2, n0.cross(n1).dot(along));
    g.half_cosine[e] = (n1 + n0).norm() / 2;
  }
  return g;
}

WallEnergy::Deformation WallEnergy::deformation(const Eigen::VectorXd& q, int triangle) const {
  const auto v = triangles_.row(triangle);
  const auto& gradients = triangle_rest_[static_cast<size_t>(triangle)].gradients;
  // The gradients add up to zero.
  return (point(q, v[1]) - point(q, v[0])) * gradients.col(1).transpose() +
         (point(q, v[2]) - point(q, v[0])) * gradients.col(2).transpose();
}

TriangleState WallEnergy::state(const Eigen::VectorXd& q, const Geometry& g, int triangle,
                                const Deformation& f) const {
  TriangleState s;
  s.metric = metric_of(f);
  if (triangle_rest_[static_cast<size_t>(triangle)].relief > 0) {
    const int partner = partner_[static_cast<size_t>(triangle)];
    s.partner_shear = membrane_strain(law_, metric_of(deformation(q, partner))).strain[2];
  }
  if (triangle_rest_[static_cast<size_t>(triangle)].leaning)
    for (int k = 0; k < 3; ++k)
      if (const int at = lean_unknown_[static_cast<size_t>(triangles_(triangle, k))]; at >= 0)
        s.lean[k] = q[at] + lean_rest_[static_cast<size_t>(triangles_(triangle, k))];
  const Sides& sides = sides_[static_cast<size_t>(triangle)];
  for (int k = 0; k < 3; ++k) {
    const auto e = static_cast<size_t>(sides.edge[static_cast<size_t>(k)]);
    s.given[static_cast<size_t>(k)] = edges_[e].glued;
    if (edges_[e].glued) {
      const auto v = triangles_.row(triangle);
      const Vec3 across = point(q, v[(k + 1) % 3]) + point(q, v[(k + 2) % 3]) - 2 * point(q, v[k]);
      s.half_sine[k] = q.segment<3>(edges_[e].unknown).dot(across);
      s.half_cosine[k] = s.xi[k] = 0;
    } else {
      s.half_sine[k] = g.half_sine[e];
      s.half_cosine[k] = g.half_cosine[e];
      s.xi[k] = sides.sign[k] * (q[edges_[e].unknown] + xi_rest_[e]);
    }
  }
  return s;
}

HingeSide WallEnergy::side(const Eigen::VectorXd& q, const Geometry& g, int edge, int which) const {
  const auto e = static_cast<size_t>(edge);
  const auto w = static_cast<size_t>(which);
  const auto t = static_cast<size_t>(edge_triangle_[e][w]);
  return {point(q, edges_[e].a),
          point(q, edges_[e].b),
          point(q, edge_apex_[e][w]),
          g.normal[t],
          g.area2[t],
          which == 0};
}

double WallEnergy::value(const Eigen::VectorXd& q) const {
  const Geometry g = geometry(q, whole_);
  double energy = 0;
  for (int t = 0; t < triangles_.rows(); ++t) {
    const TriangleRest& rest = triangle_rest_[static_cast<size_t>(t)];
    energy += triangle_value(law_, rest, state(q, g, t, deformation(q, t)));
  }
  return energy;
}

double WallEnergy::gradient(const Eigen::VectorXd& q, Eigen::VectorXd& g) const {
  return gradient(q, g, whole_);
}

double WallEnergy::gradient(const Eigen::VectorXd& q, Eigen::VectorXd& gradient,
                            const WallPart& part) const {
  const Geometry g = geometry(q, part);
  gradient.setZero(q.size());
  std::vector<double> by_angle(edges_.size(), 0);
  double energy = 0;
  for (const int t : part.triangles) {
    const TriangleRest& rest = triangle_rest_[static_cast<size_t>(t)];
    const Deformation f = deformation(q, t);
    const TriangleEnergy e =
        triangle_energy(law_, rest, state(q, g, t, f), SecondDerivatives::none);
    energy += e.value;
    Deformation stress;  // d E / d F
    stress.col(0) = 2 * e.gradient[0] * f.col(0) + e.gradient[2] * f.col(1);
    stress.col(1) = 2 * e.gradient[1] * f.col(1) + e.gradient[2] * f.col(0);
    const auto v = triangles_.row(t);
    const Sides& sides = sides_[static_cast<size_t>(t)];
    for (int k = 0; k < 3; ++k) gradient.segment<3>(3 * v[k]) += stress * rest.gradients.col(k);
    if (rest.leaning)
      for (int k = 0; k < 3; ++k)
        if (const int at = lean_unknown_[static_cast<size_t>(v[k])]; at >= 0)
          gradient[at] += e.lean_gradient[k];
    for (int k = 0; k < 3; ++k) {
      const auto edge = static_cast<size_t>(sides.edge[static_cast<size_t>(k)]);
      const int unknown = edges_[edge].unknown;
      const double moment = e.gradient[3 + k];
      if (!edges_[edge].glued) {
        by_angle[edge] += moment;
        gradient[unknown] += sides.sign[k] * e.gradient[6 + k];
        continue;
      }
      const int i = v[(k + 1) % 3], j = v[(k + 2) % 3];
      const Vec3 force = moment * q.segment<3>(unknown);
      gradient.segment<3>(unknown) += moment * (point(q, i) + point(q, j) - 2 * point(q, v[k]));
      gradient.segment<3>(3 * i) += force;
      gradient.segment<3>(3 * j) += force;
      gradient.segment<3>(3 * v[k]) -= 2 * force;
    }
  }
  for (const int edge : part.edges) {
    const auto e = static_cast<size_t>(edge);
    if (edges_[e].rim) continue;
    for (size_t which = 0; which < 2; ++which) {
      const HingeSide hinge = side(q, g, edge, static_cast<int>(which));
      const std::array<int, 3> vertex{edges_[e].a, edges_[e].b, edge_apex_[e][which]};
      for (int i = 0; i < 3; ++i)
        gradient.segment<3>(3 * vertex[static_cast<size_t>(i)]) += by_angle[e] * hinge.gradient(i);
    }
  }
  return energy;
}

// Compares the faces of a triangle with the extremes found so far.
void WallEnergy::see_faces(const Eigen::VectorXd& q, int triangle, const Vec3& bend,
                           FaceExtremes& extremes) const {
  const WallSection& section = sections_[static_cast<size_t>(triangle)];
  const Vec3 strain = membrane_strain(Law::biot, metric_of(deformation(q, triangle))).strain;
  const FaceStretches faces =
      face_stretches(section.inner, section.outer, section.curvature, strain, bend);
  const auto v = triangles_.row(triangle);
  const Vec3 middle = (point(q, v[0]) + point(q, v[1]) + point(q, v[2])) / 3;
  if (faces.least < extremes.least) {
    extremes.least = faces.least;
    extremes.least_place = middle;
  }
  if (faces.largest > extremes.largest) {
    extremes.largest = faces.largest;
    extremes.largest_place = middle;
  }
}

WallReport WallEnergy::report(const Eigen::VectorXd& q) const {
  const Geometry g = geometry(q, whole_);
  WallReport report;
  for (int t = 0; t < triangles_.rows(); ++t) {
    const TriangleRest& rest = triangle_rest_[static_cast<size_t>(t)];
    const TriangleEnergy e =
        triangle_energy(law_, rest, state(q, g, t, deformation(q, t)), SecondDerivatives::none);
    const Vec3 strain = e.strains.head<3>(), bending = e.strains.tail<3>();
    // A prestress is that of strains in the state of no stress, of which these are the sum.
    const Vec6 whole = e.strains + prestrain(rest);
    double bend =
        whole.tail<3>().dot(rest.stiffness.bottomRightCorner<3, 3>() * whole.tail<3>()) / 2;
    double coupling = whole.head<3>().dot(rest.stiffness.topRightCorner<3, 3>() * whole.tail<3>());
    if (rest.large) {
      Vec6 alone = Vec6::Zero();
      alone.tail<3>() = bending;
      const double only_bend = large_strain_energy(*rest.large, alone, false).value;
      alone << strain, Vec3::Zero();
      coupling = e.value - rest.stored - rest.prestress.dot(e.strains) - e.shear - only_bend -
                 large_strain_energy(*rest.large, alone, false).value;
      bend = only_bend + rest.prestress.tail<3>().dot(bending);
    }
    bend += e.shear;
    report.membrane += e.value - bend - coupling;
    report.bending += bend;
    report.coupling += coupling;
    // c = sum_k b_k g_k g_k^T. The conjugate M of c solves (g_k g_k^T) : M = stress_k / area.
    Mat3 dyads;
    for (int k = 0; k < 3; ++k) {
      const Vec2 d = rest.gradients.col(k);
      dyads.col(k) << d[0] * d[0], d[1] * d[1], 2 * d[0] * d[1];
    }
    report.strain.push_back(strain);
    report.bend.push_back(dyads * bending);
    report.force.push_back(e.stress.head<3>() / rest.area);
    see_faces(q, t, dyads * bending, report.faces);
    report.moment.push_back(dyads.transpose().inverse() * e.stress.tail<3>() / rest.area);
  }
  const auto sharpest = std::min_element(g.half_cosine.begin(), g.half_cosine.end());
  report.sharpest_fold = 2 * std::acos(std::min(1.0, *sharpest));
  const WallEdge& edge = edges_[static_cast<size_t>(sharpest - g.half_cosine.begin())];
  report.fold_place = (point(q, edge.a) + point(q, edge.b)) / 2;
  return report;
}

}  // namespace vasorod
