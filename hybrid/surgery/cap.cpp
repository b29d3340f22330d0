#include "surgery/cap.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "geometry/triangle_surface.h"

namespace vasorod {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>;
using Structure =
    CGAL::Triangulation_data_structure_2<VertexBase,
                                         CGAL::Constrained_triangulation_face_base_2<Kernel>>;
using Delaunay = CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure>;

double cross(const Vec2& a, const Vec2& b) {
  return a.x() * b.y() - a.y() * b.x();
}

// Even-odd rule: whether p lies inside the polygon.
bool inside(const std::vector<Vec2>& polygon, const Vec2& p) {
  bool odd = false;
  for (size_t k = 0; k < polygon.size(); ++k) {
    const Vec2 &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
    if ((a.y() > p.y()) != (b.y() > p.y()) &&
        p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x()))
      odd = !odd;
  }
  return odd;
}

double distance_to(const std::vector<Vec2>& polygon, const Vec2& p) {
  double best = std::numeric_limits<double>::infinity();
  for (size_t k = 0; k < polygon.size(); ++k) {
    const Vec2& a = polygon[k];
    const Vec2 e = polygon[(k + 1) % polygon.size()] - a;
    const double t = std::clamp((p - a).dot(e) / e.squaredNorm(), 0.0, 1.0);
    best = std::min(best, (p - a - t * e).norm());
  }
  return best;
}

// The constrained Delaunay triangles inside a polygon (its corners are points 0 to count - 1),
// counter-clockwise.
std::vector<std::array<int, 3>> triangulate(const std::vector<Vec2>& points, size_t count,
                                            const std::vector<Vec2>& polygon) {
  Delaunay delaunay;
  std::vector<Delaunay::Vertex_handle> handles;
  for (size_t i = 0; i < points.size(); ++i) {
    handles.push_back(delaunay.insert(Kernel::Point_2(points[i].x(), points[i].y())));
    handles.back()->info() = static_cast<int>(i);
  }
  for (size_t k = 0; k < count; ++k)
    delaunay.insert_constraint(handles[k], handles[(k + 1) % count]);
  std::vector<std::array<int, 3>> triangles;
  for (auto face = delaunay.finite_faces_begin(); face != delaunay.finite_faces_end(); ++face) {
    const std::array<int, 3> c{face->vertex(0)->info(), face->vertex(1)->info(),
                               face->vertex(2)->info()};
    const bool inner =
        *std::max_element(c.begin(), c.end()) >= static_cast<int>(count);  // has a point inside
    const Vec2 center = (points[static_cast<size_t>(c[0])] + points[static_cast<size_t>(c[1])] +
                         points[static_cast<size_t>(c[2])]) /
                        3;
    if (inner || inside(polygon, center)) triangles.push_back(c);
  }
  return triangles;
}

// Points of a triangular grid of spacing h inside the polygon, at a distance from its edges.
std::vector<Vec2> grid_inside(const std::vector<Vec2>& polygon, double h) {
  Vec2 low = polygon[0], high = polygon[0];
  for (const Vec2& p : polygon) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  std::vector<Vec2> points;
  const double row = h * std::sqrt(3.0) / 2;
  for (int j = 0; low.y() + j * row < high.y(); ++j)
    for (int i = 0; low.x() + i * h < high.x() + h; ++i) {
      const Vec2 p(low.x() + (i + 0.5 * (j % 2)) * h, low.y() + j * row);
      if (inside(polygon, p) && distance_to(polygon, p) > 0.6 * h) points.push_back(p);
    }
  return points;
}

// Barycentric coordinates of p in the triangle of the polygon's own triangulation that fits best.
void add_source(VertexSources& sources, const std::vector<std::array<int, 3>>& triangles,
                const std::vector<Vec2>& polygon, const std::vector<int>& rim, const Vec2& p) {
  double best = -std::numeric_limits<double>::infinity();
  std::vector<std::pair<int, double>> terms(3);
  for (const auto& c : triangles) {
    const Vec2 &x = polygon[static_cast<size_t>(c[0])], &y = polygon[static_cast<size_t>(c[1])],
               &z = polygon[static_cast<size_t>(c[2])];
    const double whole = cross(y - x, z - x);
    const Vec3 w(cross(y - p, z - p) / whole, cross(z - p, x - p) / whole,
                 cross(x - p, y - p) / whole);
    if (!(w.minCoeff() > best)) continue;
    best = w.minCoeff();
    for (size_t k = 0; k < 3; ++k)
      terms[k] = {rim[static_cast<size_t>(c[k])], w[static_cast<int>(k)]};
  }
  std::sort(terms.begin(), terms.end());
  VertexSource source;
  for (const auto& [vertex, weight] : terms) {
    source.vertex.push_back(vertex);
    source.weight.push_back(weight);
  }
  sources.push_back(std::move(source));
}

}  // namespace

CappedSurface close_planar_hole(const TriangleSurface& surface, const std::vector<int>& loop) {
  const size_t count = loop.size();
  // In the hole's plane, against the boundary's direction, so that the cap lies on the left.
  const Vec3 origin = surface.points.row(loop[0]);
  const Vec3 normal = -area_vector(surface.points, loop).normalized();
  const Vec3 e1 = normal.unitOrthogonal(), e2 = normal.cross(e1);
  std::vector<int> rim(loop.rbegin(), loop.rend());
  std::vector<Vec2> points;
  for (const int v : rim) {
    const Vec3 p = surface.points.row(v).transpose();
    points.emplace_back((p - origin).dot(e1), (p - origin).dot(e2));
  }
  const std::vector<Vec2> outline = points;
  for (const Vec2& p :
       grid_inside(outline, perimeter(surface.points, loop) / static_cast<double>(count)))
    points.push_back(p);

  auto triangles = triangulate(points, count, outline);
  for (int round = 0; round < 6; ++round) {  // Laplacian smoothing
    std::vector<Vec2> sum(points.size(), Vec2::Zero());
    std::vector<double> weight(points.size(), 0);
    for (const auto& c : triangles)
      for (size_t k = 0; k < 3; ++k)
        for (const size_t l : {(k + 1) % 3, (k + 2) % 3}) {
          sum[static_cast<size_t>(c[k])] += points[static_cast<size_t>(c[l])];
          weight[static_cast<size_t>(c[k])] += 1;
        }
    for (size_t i = count; i < points.size(); ++i)
      if (weight[i] > 0) points[i] = sum[i] / weight[i];
    triangles = triangulate(points, count, outline);
  }

  CappedSurface result;
  const auto old_points = surface.points.rows(), old_triangles = surface.triangles.rows();
  result.surface.points.resize(old_points + static_cast<Eigen::Index>(points.size() - count), 3);
  result.surface.points.topRows(old_points) = surface.points;
  for (int v = 0; v < old_points; ++v) result.sources.push_back(VertexSource::original(v));
  const auto of_outline = triangulate(outline, count, outline);
  for (size_t i = count; i < points.size(); ++i) {
    add_source(result.sources, of_outline, outline, rim, points[i]);
    Vec3 at = Vec3::Zero();
    const VertexSource& source = result.sources.back();
    for (size_t k = 0; k < 3; ++k)
      at += source.weight[k] * surface.points.row(source.vertex[k]).transpose();
    result.surface.points.row(old_points + static_cast<Eigen::Index>(i - count)) = at.transpose();
  }
  result.surface.triangles.resize(old_triangles + static_cast<Eigen::Index>(triangles.size()), 3);
  result.surface.triangles.topRows(old_triangles) = surface.triangles;
  const auto number = [&](int i) {
    return static_cast<size_t>(i) < count
               ? rim[static_cast<size_t>(i)]
               : static_cast<int>(old_points) + i - static_cast<int>(count);
  };
  for (size_t t = 0; t < triangles.size(); ++t)
    for (size_t k = 0; k < 3; ++k)
      result.surface.triangles(old_triangles + static_cast<Eigen::Index>(t), static_cast<int>(k)) =
          number(triangles[t][k]);
  return result;
}

}  // namespace vasorod
