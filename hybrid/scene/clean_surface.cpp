#include "scene/clean_surface.h"

#include <algorithm>
#include <set>

#include <Eigen/Geometry>

#include "geometry/triangle_surface.h"
#include "scene/read_polydata.h"

namespace vasorod {

namespace {

// The triangles around each point, kept up to date while edges collapse and turn.
class Mesh {
 public:
  explicit Mesh(TriangleSurface& surface)
      : surface_(surface),
        around_(static_cast<size_t>(surface.points.rows())),
        alive_(static_cast<size_t>(surface.triangles.rows()), 1) {
    for (int t = 0; t < surface.triangles.rows(); ++t)
      for (int k = 0; k < 3; ++k) around(surface.triangles(t, k)).insert(t);
  }

  int triangles() const { return static_cast<int>(surface_.triangles.rows()); }
  bool alive(int t) const { return alive_[static_cast<size_t>(t)] != 0; }
  int corner(int t, int k) const { return surface_.triangles(t, k % 3); }
  Vec3 point(int i) const { return surface_.points.row(i); }
  double length(int a, int b) const { return (point(a) - point(b)).norm(); }

  std::vector<int> on_edge(int a, int b) const {
    std::vector<int> both;
    std::set_intersection(around(a).begin(), around(a).end(), around(b).begin(), around(b).end(),
                          std::back_inserter(both));
    return both;
  }
  bool on_boundary(int a) const {
    return std::any_of(around(a).begin(), around(a).end(), [&](int t) {
      return std::any_of(tripled.begin(), tripled.end(), [&](int k) {
        const int b = corner(t, k);
        return b != a && on_edge(a, b).size() == 1;
      });
    });
  }
  std::set<int> neighbours(int a) const {
    std::set<int> ring;
    for (const int t : around(a))
      for (int k = 0; k < 3; ++k)
        if (corner(t, k) != a) ring.insert(corner(t, k));
    return ring;
  }
  int opposite(int t, int a, int b) const {
    for (int k = 0; k < 3; ++k)
      if (corner(t, k) != a && corner(t, k) != b) return corner(t, k);
    return -1;
  }
  // Height over the longest edge.
  double height(int t) const {
    const Vec3 e = point(corner(t, 1)) - point(corner(t, 0)), f = point(corner(t, 2)) - point(corner(t, 0));
    const double longest = std::max({e.norm(), f.norm(), (e - f).norm()});
    return longest == 0 ? 0 : e.cross(f).norm() / longest;
  }

  // The link condition (Dey et al. 1999): the collapse keeps the surface manifold and its topology.
  bool may_collapse(int a, int b) const {
    const auto both = on_edge(a, b);
    const auto ring_a = neighbours(a), ring_b = neighbours(b);
    std::vector<int> common;
    std::set_intersection(ring_a.begin(), ring_a.end(), ring_b.begin(), ring_b.end(),
                          std::back_inserter(common));
    if (common.size() != both.size()) return false;
    if (both.size() == 2 && on_boundary(a) && on_boundary(b)) return false;
    return around(a).size() + around(b).size() > 2 * both.size() + 1;
  }
  void collapse(int a, int b) {
    const int keep = std::min(a, b), gone = std::max(a, b);
    if (on_boundary(gone) && !on_boundary(keep)) surface_.points.row(keep) = surface_.points.row(gone);
    for (const int t : on_edge(a, b)) kill(t);
    const std::set<int> moved = around(gone);
    for (const int t : moved) {
      for (int k = 0; k < 3; ++k)
        if (surface_.triangles(t, k) == gone) surface_.triangles(t, k) = keep;
      around(keep).insert(t);
    }
    around(gone).clear();
  }
  // Turns the edge a, b of triangles t, u. False where that would double an edge or flatten another triangle.
  bool turn(int t, int u, int a, int b, double least) {
    const int c = opposite(t, a, b), d = opposite(u, a, b);
    if (c == d || !on_edge(c, d).empty()) return false;
    const Eigen::RowVector3i t_before = surface_.triangles.row(t), u_before = surface_.triangles.row(u);
    replace(t, b, d);
    replace(u, a, c);
    if (std::min(height(t), height(u)) > least) return true;
    reset(t, t_before);
    reset(u, u_before);
    return false;
  }
  void kill(int t) {
    for (int k = 0; k < 3; ++k) around(corner(t, k)).erase(t);
    alive_[static_cast<size_t>(t)] = 0;
  }

 private:
  static constexpr std::array<int, 3> tripled{0, 1, 2};
  std::set<int>& around(int i) { return around_[static_cast<size_t>(i)]; }
  const std::set<int>& around(int i) const { return around_[static_cast<size_t>(i)]; }
  void replace(int t, int from, int to) {
    for (int k = 0; k < 3; ++k)
      if (surface_.triangles(t, k) == from) surface_.triangles(t, k) = to;
    around(from).erase(t);
    around(to).insert(t);
  }
  void reset(int t, const Eigen::RowVector3i& corners) {
    for (int k = 0; k < 3; ++k) around(corner(t, k)).erase(t);
    surface_.triangles.row(t) = corners;
    for (int k = 0; k < 3; ++k) around(corner(t, k)).insert(t);
  }

  TriangleSurface& surface_;
  std::vector<std::set<int>> around_;
  std::vector<char> alive_;
};

bool collapse_one(Mesh& mesh, int t, double shortest) {
  for (int k = 0; k < 3; ++k) {
    const int a = mesh.corner(t, k), b = mesh.corner(t, k + 1);
    if (mesh.length(a, b) < shortest && mesh.may_collapse(a, b)) {
      mesh.collapse(a, b);
      return true;
    }
  }
  return false;
}

bool straighten_one(Mesh& mesh, int t, double least) {
  int longest = 0;
  for (int k = 1; k < 3; ++k)
    if (mesh.length(mesh.corner(t, k), mesh.corner(t, k + 1)) >
        mesh.length(mesh.corner(t, longest), mesh.corner(t, longest + 1)))
      longest = k;
  const int a = mesh.corner(t, longest), b = mesh.corner(t, longest + 1);
  const auto both = mesh.on_edge(a, b);
  if (both.size() == 2)
    return mesh.turn(t, both[0] == t ? both[1] : both[0], a, b, std::max(least, mesh.height(t)));
  // On an end the flat triangle goes, and the end runs through its third point, unless that is on an end
  // already.
  if (mesh.on_boundary(mesh.corner(t, longest + 2))) return false;
  mesh.kill(t);
  return true;
}

}  // namespace

void clean_surface(LoadedSurface& loaded) {
  const double least = degenerate_fraction * mean_edge_length(loaded.surface);
  Mesh mesh(loaded.surface);
  bool changed = true;
  while (changed) {  // every change removes a triangle or raises its height above the limit, so this ends
    changed = false;
    for (int t = 0; t < mesh.triangles(); ++t) {
      if (mesh.alive(t) && collapse_one(mesh, t, least)) {
        ++loaded.report.collapsed_edges;
        changed = true;
      }
      if (mesh.alive(t) && mesh.height(t) < least && straighten_one(mesh, t, least)) {
        ++loaded.report.straightened;
        changed = true;
      }
    }
  }
  std::vector<int> keep;
  for (int t = 0; t < mesh.triangles(); ++t)
    if (mesh.alive(t)) keep.push_back(t);
  if (static_cast<int>(keep.size()) == mesh.triangles()) return;
  keep_triangles(loaded, keep);
  drop_unused_points(loaded);
}

}  // namespace vasorod
