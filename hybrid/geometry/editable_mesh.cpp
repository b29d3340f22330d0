#include "geometry/editable_mesh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <iterator>

#include "data/index.h"

namespace vasorod {
namespace {

// The corner of the triangle after v, and the one before.
std::pair<int, int> around(const EditableMesh::Triangle& corners, int v) {
  for (size_t k = 0; k < 3; ++k)
    if (corners[k] == v) return {corners[(k + 1) % 3], corners[(k + 2) % 3]};
  return {-1, -1};
}

}  // namespace

EditableMesh::EditableMesh(const TriangleSurface& surface) {
  const Eigen::Index count = surface.points.rows();
  points_.resize(index(count));
  incident_.resize(index(count));
  for (Eigen::Index v = 0; v < count; ++v) points_[index(v)] = surface.points.row(v);
  triangles_.reserve(index(surface.triangles.rows()) + 64);
  for (Eigen::Index t = 0; t < surface.triangles.rows(); ++t)
    add_triangle({surface.triangles(t, 0), surface.triangles(t, 1), surface.triangles(t, 2)});
}

std::vector<int> EditableMesh::alive_triangles() const {
  std::vector<int> rows;
  for (int t = 0; t < triangle_count(); ++t)
    if (alive(t)) rows.push_back(t);
  return rows;
}

Vec3 EditableMesh::normal(int t) const {
  return (point(corner(t, 1)) - point(corner(t, 0)))
      .cross(point(corner(t, 2)) - point(corner(t, 0)));
}

double EditableMesh::height(int t) const {
  const double longest =
      std::max({length(corner(t, 0), corner(t, 1)), length(corner(t, 1), corner(t, 2)),
                length(corner(t, 2), corner(t, 0))});
  return longest == 0 ? 0 : normal(t).norm() / longest;
}

int EditableMesh::add_vertex(const Vec3& point) {
  points_.push_back(point);
  incident_.emplace_back();
  return vertex_count() - 1;
}

int EditableMesh::add_triangle(const Triangle& corners) {
  const int t = triangle_count();
  triangles_.push_back(corners);
  for (const int v : corners) incident_[index(v)].push_back(t);
  return t;
}

void EditableMesh::remove_triangle(int t) {
  for (const int v : triangle(t)) std::erase(incident_[index(v)], t);
  triangles_[index(t)] = {-1, -1, -1};
}

void EditableMesh::replace_corner(int t, int from, int to) {
  std::replace(triangles_[index(t)].begin(), triangles_[index(t)].end(), from, to);
  std::erase(incident_[index(from)], t);
  incident_[index(to)].push_back(t);
}

int EditableMesh::triangle_left_of(int a, int b) const {
  for (const int t : triangles_of(a)) {
    const auto& c = triangle(t);
    for (size_t k = 0; k < 3; ++k)
      if (c[k] == a && c[(k + 1) % 3] == b) return t;
  }
  return -1;
}

std::vector<int> EditableMesh::on_edge(int a, int b) const {
  std::vector<int> both;
  for (const int t : {triangle_left_of(a, b), triangle_left_of(b, a)})
    if (t >= 0) both.push_back(t);
  std::sort(both.begin(), both.end());
  return both;
}

int EditableMesh::opposite(const Triangle& corners, int a, int b) {
  for (const int v : corners)
    if (v != a && v != b) return v;
  return -1;
}

std::vector<int> EditableMesh::ring(int v) const {
  const auto& incident = triangles_of(v);
  if (incident.empty()) return {};
  // Start where no triangle lies clockwise of the first one (a boundary), else anywhere.
  int first = incident.front();
  for (size_t step = 0; step < incident.size(); ++step) {
    const int before = triangle_left_of(around(triangle(first), v).first, v);
    if (before < 0 || before == incident.front()) break;
    first = before;
  }
  std::vector<int> result{around(triangle(first), v).first};
  for (int t = first;;) {
    const int next = around(triangle(t), v).second;
    if (next == result.front()) break;
    result.push_back(next);
    t = triangle_left_of(v, next);
    if (t < 0 || result.size() > incident.size() + 1) break;
  }
  return result;
}

bool EditableMesh::on_boundary(int v) const {
  return ring(v).size() != triangles_of(v).size();
}

bool EditableMesh::may_collapse(int a, int b) const {
  const auto both = on_edge(a, b);
  std::vector<int> ring_a = ring(a), ring_b = ring(b), common;
  std::sort(ring_a.begin(), ring_a.end());
  std::sort(ring_b.begin(), ring_b.end());
  std::set_intersection(ring_a.begin(), ring_a.end(), ring_b.begin(), ring_b.end(),
                        std::back_inserter(common));
  if (common.size() != both.size()) return false;
  if (both.size() == 2 && on_boundary(a) && on_boundary(b)) return false;
  // A lone triangle, or the two sides of one, must not vanish.
  return triangles_of(a).size() + triangles_of(b).size() > 2 * both.size() + 1;
}

Vec3 EditableMesh::collapsed_position(int a, int b) const {
  const int keep = std::min(a, b), gone = std::max(a, b);
  return on_boundary(gone) && !on_boundary(keep) ? point(gone) : point(keep);
}

bool EditableMesh::collapse_keeps_shape(int a, int b, double longest) const {
  const Vec3 position = collapsed_position(a, b);
  for (const int moved : {a, b})
    for (const int t : triangles_of(moved)) {
      std::array<Vec3, 3> p;
      bool has_both = false;
      for (size_t k = 0; k < 3; ++k) {
        const int i = triangle(t)[k];
        has_both = has_both || i == (moved == a ? b : a);
        p[k] = i == moved ? position : point(i);
      }
      if (has_both) continue;
      const Vec3 before = normal(t), after = (p[1] - p[0]).cross(p[2] - p[0]);
      if (before.dot(after) < 0.5 * before.norm() * after.norm()) return false;
      for (size_t k = 0; k < 3; ++k)
        if ((p[k] - p[(k + 1) % 3]).norm() > longest) return false;
    }
  return true;
}

void EditableMesh::collapse(int a, int b) {
  const int keep = std::min(a, b), gone = std::max(a, b);
  points_[index(keep)] = collapsed_position(a, b);
  for (const int t : on_edge(a, b)) remove_triangle(t);
  const std::vector<int> moved = triangles_of(gone);
  for (const int t : moved) replace_corner(t, gone, keep);
}

bool EditableMesh::turn(int t, int u, int a, int b, double least) {
  const int c = opposite(triangle(t), a, b), d = opposite(triangle(u), a, b);
  if (c == d || joined(c, d)) return false;
  replace_corner(t, b, d);
  replace_corner(u, a, c);
  if (std::min(height(t), height(u)) > least) return true;
  replace_corner(t, d, b);
  replace_corner(u, c, a);
  return false;
}

void EditableMesh::store(TriangleSurface& surface) const {
  for (int v = 0; v < vertex_count(); ++v) surface.points.row(v) = point(v);
  for (int t = 0; t < triangle_count(); ++t)
    for (int k = 0; alive(t) && k < 3; ++k) surface.triangles(t, k) = corner(t, k);
}

}  // namespace vasorod
