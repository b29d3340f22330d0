#include "surface_file/editable_mesh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <iterator>

namespace vasorod {

EditableMesh::EditableMesh(TriangleSurface& surface)
    : surface_(surface),
      around_(static_cast<size_t>(surface.points.rows())),
      alive_(static_cast<size_t>(surface.triangles.rows()), 1) {
  for (int t = 0; t < surface.triangles.rows(); ++t)
    for (int k = 0; k < 3; ++k) around(surface.triangles(t, k)).insert(t);
}

std::vector<int> EditableMesh::alive() const {
  std::vector<int> rows;
  for (int t = 0; t < triangles(); ++t)
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

std::vector<int> EditableMesh::on_edge(int a, int b) const {
  std::vector<int> both;
  std::set_intersection(around(a).begin(), around(a).end(), around(b).begin(), around(b).end(),
                        std::back_inserter(both));
  return both;
}

std::set<int> EditableMesh::neighbours(int i) const {
  std::set<int> ring;
  for (const int t : around(i))
    for (int k = 0; k < 3; ++k)
      if (corner(t, k) != i) ring.insert(corner(t, k));
  return ring;
}

bool EditableMesh::on_boundary(int i) const {
  const auto ring = neighbours(i);
  return std::any_of(ring.begin(), ring.end(), [&](int j) { return on_edge(i, j).size() == 1; });
}

int EditableMesh::opposite(int t, int a, int b) const {
  for (int k = 0; k < 3; ++k)
    if (corner(t, k) != a && corner(t, k) != b) return corner(t, k);
  return -1;
}

bool EditableMesh::may_collapse(int a, int b) const {
  const auto both = on_edge(a, b);
  const auto ring_a = neighbours(a), ring_b = neighbours(b);
  std::vector<int> common;
  std::set_intersection(ring_a.begin(), ring_a.end(), ring_b.begin(), ring_b.end(),
                        std::back_inserter(common));
  if (common.size() != both.size()) return false;
  if (both.size() == 2 && on_boundary(a) && on_boundary(b)) return false;
  // A lone triangle, or the two sides of one, must not vanish.
  return around(a).size() + around(b).size() > 2 * both.size() + 1;
}

Vec3 EditableMesh::collapsed_position(int a, int b) const {
  const int keep = std::min(a, b), gone = std::max(a, b);
  return on_boundary(gone) && !on_boundary(keep) ? point(gone) : point(keep);
}

bool EditableMesh::collapse_keeps_shape(int a, int b, double longest) const {
  const Vec3 position = collapsed_position(a, b);
  for (const int moved : {a, b})
    for (const int t : around(moved)) {
      std::array<Vec3, 3> p;
      bool has_both = false;
      for (size_t k = 0; k < 3; ++k) {
        const int i = corner(t, static_cast<int>(k));
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
  surface_.points.row(keep) = collapsed_position(a, b).transpose();
  for (const int t : on_edge(a, b)) remove(t);
  const std::set<int> moved = around(gone);
  for (const int t : moved) replace(t, gone, keep);
}

bool EditableMesh::turn(int t, int u, int a, int b, double least) {
  const int c = opposite(t, a, b), d = opposite(u, a, b);
  if (c == d || !on_edge(c, d).empty()) return false;
  replace(t, b, d);
  replace(u, a, c);
  if (std::min(height(t), height(u)) > least) return true;
  replace(t, d, b);
  replace(u, c, a);
  return false;
}

void EditableMesh::remove(int t) {
  for (int k = 0; k < 3; ++k) around(corner(t, k)).erase(t);
  alive_[static_cast<size_t>(t)] = 0;
}

void EditableMesh::replace(int t, int from, int to) {
  for (int k = 0; k < 3; ++k)
    if (surface_.triangles(t, k) == from) surface_.triangles(t, k) = to;
  around(from).erase(t);
  around(to).insert(t);
}

}  // namespace vasorod
