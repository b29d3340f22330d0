#include "geometry/surface_editor.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <deque>
#include <set>

#include "data/index.h"
#include "geometry/triangle_surface.h"

namespace vasorod {
namespace {

using Corners = std::array<Vec3, 3>;

Vec3 normal_of(const Corners& c) {
  return (c[1] - c[0]).cross(c[2] - c[0]);
}

double quality_of(const Corners& c) {
  const double squares =
      (c[1] - c[0]).squaredNorm() + (c[2] - c[1]).squaredNorm() + (c[0] - c[2]).squaredNorm();
  return squares > 0 ? 2 * std::sqrt(3.0) * normal_of(c).norm() / squares : 0;
}

double shortest_of(const Corners& c) {
  return std::min({(c[1] - c[0]).norm(), (c[2] - c[1]).norm(), (c[0] - c[2]).norm()});
}

double angle_at(const Vec3& corner, const Vec3& a, const Vec3& b) {
  return std::atan2((a - corner).cross(b - corner).norm(), (a - corner).dot(b - corner));
}

}  // namespace

SurfaceEditor::SurfaceEditor(const TriangleSurface& surface, const EditTolerances& tolerances)
    : EditableMesh(surface),
      tolerances_(tolerances),
      mean_edge_(mean_edge_length(surface)),
      input_count_(static_cast<int>(surface.points.rows())),
      sources_(index(input_count_)),
      touched_(index(input_count_), 0) {
  for (int v = 0; v < input_count_; ++v) sources_[index(v)] = VertexSource::original(v);
}

Vec3 SurfaceEditor::point(const Blend& blend) const {
  Vec3 sum = Vec3::Zero();
  for (const auto& [v, weight] : blend) sum += weight * point(v);
  return sum;
}

VertexSource SurfaceEditor::source_of(const Blend& parts) const {
  std::vector<const VertexSource*> sources;
  std::vector<double> weights;
  for (const auto& [v, weight] : parts) {
    sources.push_back(&source(v));
    weights.push_back(weight);
  }
  return blend(sources, weights);
}

int SurfaceEditor::add_blend(const Blend& blend) {
  VertexSource from = source_of(blend);
  const int v = add_vertex(point(blend));
  sources_.push_back(std::move(from));
  touched_.push_back(1);
  return v;
}

int SurfaceEditor::split_edge(int a, int b, double t) {
  const int m = add_blend({{a, 1 - t}, {b, t}});
  for (const auto& [i, j] : {std::pair{a, b}, std::pair{b, a}}) {
    const int left = triangle_left_of(i, j);
    if (left < 0) continue;
    const int o = opposite(triangle(left), i, j);
    remove_triangle(left);
    add_triangle({i, m, o});
    add_triangle({m, j, o});
  }
  return m;
}

int SurfaceEditor::split_triangle(int t, const Vec3& barycentric) {
  const auto c = triangle(t);
  const int m = add_blend({{c[0], barycentric[0]}, {c[1], barycentric[1]}, {c[2], barycentric[2]}});
  remove_triangle(t);
  for (size_t k = 0; k < 3; ++k) add_triangle({c[k], c[(k + 1) % 3], m});
  return m;
}

bool SurfaceEditor::acceptable(const std::vector<Corners>& before,
                               const std::vector<Corners>& after) const {
  double quality_before = 1, shortest_before = mean_edge_;
  Vec3 mean_normal = Vec3::Zero();
  for (const Corners& c : before) {
    quality_before = std::min(quality_before, quality_of(c));
    shortest_before = std::min(shortest_before, shortest_of(c));
    mean_normal += normal_of(c);
  }
  const double quality_limit = std::min(tolerances_.min_quality, 0.7 * quality_before);
  const double length_limit = std::min(min_edge(), shortest_before);
  for (size_t k = 0; k < after.size(); ++k) {
    const Vec3 normal = normal_of(after[k]);
    // The normal to compare with: that of the old triangle, or of its surroundings if the old
    // triangle was a sliver without a reliable normal.
    const Vec3 was =
        k < before.size() && quality_of(before[k]) > 0.05 ? normal_of(before[k]) : mean_normal;
    if (normal.dot(was) <= 0.5 * normal.norm() * was.norm()) return false;
    if (quality_of(after[k]) < quality_limit || shortest_of(after[k]) < length_limit) return false;
  }
  return true;
}

bool SurfaceEditor::move(int v, const Blend& target) {
  return move(v, point(target), source_of(target));
}

bool SurfaceEditor::move(int v, const Vec3& to, const VertexSource& from) {
  std::vector<Corners> before, after;
  for (const int t : triangles_of(v)) {
    Corners c, d;
    for (size_t k = 0; k < 3; ++k) {
      c[k] = point(triangle(t)[k]);
      d[k] = triangle(t)[k] == v ? to : c[k];
    }
    before.push_back(c);
    after.push_back(d);
  }
  if (!acceptable(before, after)) return false;
  points_[index(v)] = to;
  sources_[index(v)] = from;
  touched_[index(v)] = 1;
  return true;
}

bool SurfaceEditor::collapse(int keep, int gone, const Blend& target) {
  // Link condition: the two vertices share exactly the corners opposite to their edge, and no
  // boundary is closed.
  const int left = triangle_left_of(keep, gone), right = triangle_left_of(gone, keep);
  if (left < 0 && right < 0) return false;
  const bool boundary_edge = left < 0 || right < 0;
  const auto ring_keep = ring(keep), ring_gone = ring(gone);
  int shared = 0;
  for (const int v : ring_gone)
    shared += static_cast<int>(std::count(ring_keep.begin(), ring_keep.end(), v));
  if (shared != (boundary_edge ? 1 : 2)) return false;
  if (on_boundary(gone) && !boundary_edge) return false;
  if (on_boundary(keep) && !boundary_edge && point(target) != point(keep)) return false;

  const Vec3 to = point(target);
  std::vector<Corners> before, after;
  std::vector<int> renamed;
  for (const int v : {keep, gone})
    for (const int t : triangles_of(v)) {
      if (t == left || t == right) continue;
      Corners c, d;
      for (size_t k = 0; k < 3; ++k) {
        c[k] = point(triangle(t)[k]);
        d[k] = triangle(t)[k] == v ? to : c[k];
      }
      before.push_back(c);
      after.push_back(d);
      if (v == gone) renamed.push_back(t);
    }
  // The two removed triangles count among the old ones: a short edge or a sliver may be removed
  // even if the remaining triangles are not perfect.
  for (const int t : {left, right})
    if (t >= 0)
      before.push_back({point(triangle(t)[0]), point(triangle(t)[1]), point(triangle(t)[2])});
  if (after.empty() || !acceptable(before, after)) return false;

  VertexSource from = source_of(target);
  if (left >= 0) remove_triangle(left);
  if (right >= 0) remove_triangle(right);
  for (const int t : renamed) {
    auto corners = triangle(t);
    std::replace(corners.begin(), corners.end(), gone, keep);
    remove_triangle(t);
    add_triangle(corners);
  }
  points_[static_cast<size_t>(keep)] = to;
  sources_[static_cast<size_t>(keep)] = std::move(from);
  touched_[static_cast<size_t>(keep)] = 1;
  return true;
}

// Edge a-b with c left and d right of it: whether the edge c-d is better.
bool SurfaceEditor::flip_improves(int a, int b, int c, int d) const {
  const Vec3 &pa = point(a), &pb = point(b), &pc = point(c), &pd = point(d);
  if (angle_at(pc, pa, pb) + angle_at(pd, pa, pb) <= M_PI + 1e-6) return false;
  const Vec3 n1 = normal_of({pa, pb, pc}), n2 = normal_of({pb, pa, pd});
  const Vec3 m1 = normal_of({pd, pc, pa}), m2 = normal_of({pc, pd, pb});
  const Vec3 mean = n1 + n2;
  const double flat = 0.8;  // cosine: beyond that the fold is a feature, not noise
  if (n1.dot(n2) < flat * n1.norm() * n2.norm()) return false;
  for (const Vec3& m : {m1, m2})
    if (m.dot(mean) < flat * m.norm() * mean.norm() || m.norm() == 0) return false;
  return (pc - pd).norm() >= min_edge();
}

void SurfaceEditor::improve(const std::function<bool(int, int)>& fixed) {
  std::deque<std::pair<int, int>> queue;
  std::set<std::pair<int, int>> queued;
  auto enqueue = [&](int a, int b) {
    if (a > b) std::swap(a, b);
    if (queued.insert({a, b}).second) queue.emplace_back(a, b);
  };
  for (int v = 0; v < vertex_count(); ++v) {
    if (!touched(v)) continue;
    for (const int t : triangles_of(v))
      for (size_t k = 0; k < 3; ++k) enqueue(triangle(t)[k], triangle(t)[(k + 1) % 3]);
  }
  // Every Delaunay flip on a flat patch decreases a potential. The bound guards against curved
  // corner cases.
  for (size_t guard = 20 * queue.size(); guard > 0 && !queue.empty(); --guard) {
    const auto [a, b] = queue.front();
    queue.pop_front();
    queued.erase({a, b});
    const int left = triangle_left_of(a, b), right = triangle_left_of(b, a);
    if (left < 0 || right < 0 || fixed(a, b)) continue;
    const int c = opposite(triangle(left), a, b), d = opposite(triangle(right), a, b);
    if (!touched(a) && !touched(b) && !touched(c) && !touched(d)) continue;
    if (joined(c, d) || fixed(c, d) || !flip_improves(a, b, c, d)) continue;
    remove_triangle(left);
    remove_triangle(right);
    add_triangle({d, c, a});
    add_triangle({c, d, b});
    for (const auto& [i, j] : {std::pair{a, c}, std::pair{c, b}, std::pair{b, d}, std::pair{d, a}})
      enqueue(i, j);
  }
}

int SurfaceEditor::duplicate(int v, const std::vector<int>& triangles) {
  const int copy = add_blend({{v, 1.0}});
  for (const int t : triangles) replace_corner(t, v, copy);
  return copy;
}

SurfaceEditor::Part SurfaceEditor::part(const std::vector<int>& triangles) const {
  std::vector<int> number(static_cast<size_t>(vertex_count()), -1);
  for (const int t : triangles)
    for (const int v : triangle(t)) number[static_cast<size_t>(v)] = 0;
  Part result;
  for (int v = 0; v < vertex_count(); ++v) {
    if (number[static_cast<size_t>(v)] < 0) continue;
    number[static_cast<size_t>(v)] = static_cast<int>(result.vertices.size());
    result.vertices.push_back(v);
    result.sources.push_back(source(v));
  }
  result.surface.points.resize(static_cast<Eigen::Index>(result.vertices.size()), 3);
  for (size_t i = 0; i < result.vertices.size(); ++i)
    result.surface.points.row(static_cast<Eigen::Index>(i)) = point(result.vertices[i]).transpose();
  result.surface.triangles.resize(static_cast<Eigen::Index>(triangles.size()), 3);
  for (size_t i = 0; i < triangles.size(); ++i)
    for (int k = 0; k < 3; ++k)
      result.surface.triangles(static_cast<Eigen::Index>(i), k) =
          number[static_cast<size_t>(triangle(triangles[i])[static_cast<size_t>(k)])];
  return result;
}

SurfaceEditor::Part SurfaceEditor::whole() const {
  return part(alive_triangles());
}

}  // namespace vasorod
