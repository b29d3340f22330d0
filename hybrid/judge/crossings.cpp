#include "judge/crossings.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>

#include "data/index.h"
#include "geometry/crossing_triangles.h"
#include "geometry/fans.h"
#include "geometry/ray_hits.h"
#include "geometry/triangle_surface.h"
#include "numerics/threads.h"

namespace vasorod {
namespace {

// How deep a vertex lies inside a body, and which.
struct Inside {
  int body = -1;
  double depth = 0;
};

// All bodies as one surface.
class Whole {
 public:
  Whole(const std::vector<CheckedBody>& bodies, bool now) {
    Eigen::Index points = 0, triangles = 0;
    for (const CheckedBody& body : bodies) {
      first_point_.push_back(static_cast<int>(points));
      first_triangle_.push_back(static_cast<int>(triangles));
      points += body.rest->points.rows();
      triangles += body.rest->triangles.rows();
    }
    surface_.points.resize(points, 3);
    surface_.triangles.resize(triangles, 3);
    for (std::size_t b = 0; b < bodies.size(); ++b) {
      const TriangleSurface& rest = *bodies[b].rest;
      surface_.points.middleRows(first_point_[b], rest.points.rows()) =
          now ? *bodies[b].now : rest.points;
      surface_.triangles.middleRows(first_triangle_[b], rest.triangles.rows()) =
          rest.triangles.array() + first_point_[b];
    }
  }

  // Gives both vertices of each pair one number and the place midway between them.
  void weld(const CheckedSeam& seam) {
    std::map<int, int> kept;
    for (const auto& [a, b] : seam.pairs) {
      const int first = first_point_[index(seam.a)] + a, second = first_point_[index(seam.b)] + b;
      kept[second] = first;
      surface_.points.row(first) =
          0.5 * (surface_.points.row(first) + surface_.points.row(second)).eval();
    }
    for (int& vertex : surface_.triangles.reshaped())
      if (const auto found = kept.find(vertex); found != kept.end()) vertex = found->second;
  }

  int body_of(int triangle) const {
    const auto after = std::upper_bound(first_triangle_.begin(), first_triangle_.end(), triangle);
    return static_cast<int>(after - first_triangle_.begin()) - 1;
  }

  // {a, b} -> pairs of triangles that cross, a <= b, of bodies of which one at least is marked.
  std::map<std::array<int, 2>, int> crossing_pairs(const std::vector<char>& marked) const {
    std::vector<char> triangles(index(surface_.triangles.rows()));
    for (int t = 0; t < surface_.triangles.rows(); ++t)
      triangles[index(t)] = marked[index(body_of(t))];
    std::map<std::array<int, 2>, int> count;
    for (const auto& [s, t] :
         crossing_triangles(surface_, triangles, most_self_intersections, threads()))
      ++count[{body_of(s), body_of(t)}];
    return count;
  }

  // Closes the open ends by fans, so that inside and outside are told apart everywhere.
  void close() {
    normals_ = vertex_normals(surface_);
    bodies_of_triangles_.resize(index(surface_.triangles.rows()));
    for (int t = 0; t < surface_.triangles.rows(); ++t) bodies_of_triangles_[index(t)] = body_of(t);
    std::vector<int> body_of_point(index(surface_.points.rows()), -1);
    for (int t = 0; t < surface_.triangles.rows(); ++t)
      for (int k = 0; k < 3; ++k)
        body_of_point[index(surface_.triangles(t, k))] = bodies_of_triangles_[index(t)];
    const auto loops = boundary_loops(surface_.triangles);
    for (const std::vector<int>& loop : loops)
      for (const int vertex : loop) bodies_of_triangles_.push_back(body_of_point[index(vertex)]);
    rays_.emplace(TriangleSurface{with_centroids(surface_.points, loops),
                                  with_fans(surface_.triangles, loops, surface_.points.rows())});
  }

  // Whether the space just outside the wall at a vertex is inside a vessel; then the next wall.
  // `only`: of that body alone, as if there were no other; -1: of all.
  Inside depth_of(int body, int vertex, double edge, int only = -1) const {
    const auto counts = [&](const RayHit& hit) {
      return only < 0 || bodies_of_triangles_[index(hit.triangle)] == only;
    };
    const int v = first_point_[index(body)] + vertex;
    const Vec3 normal = normals_.row(v);
    if (!(normal.squaredNorm() > 0)) return {};  // welded away, or of no triangle
    const Vec3 point = surface_.points.row(v), off = 1e-4 * edge * normal;
    // Not quite the normal, which in regular meshes passes through edges and vertices.
    const Vec3 skew(1.3e-4, -2.1e-4, 1.7e-4);
    int winding = 0;
    for (const RayHit& hit : rays_->along(point + off, (normal + skew).normalized()))
      if (counts(hit)) winding += hit.leaves ? 1 : -1;
    if (winding == 0) return {};
    // Straight on, back, and obliquely: where walls meet in a crease, the next one is beside it.
    Inside inside{-1, std::numeric_limits<double>::infinity()};
    const Vec3 side = normal.unitOrthogonal(), other = normal.cross(side);
    const double tilt = std::sqrt(3.);
    for (const Vec3& aside : {Vec3(0, 0, 0), Vec3(side), Vec3(-side), Vec3(other), Vec3(-other)})
      for (const auto& [sign, from] : {std::pair(1., 1.), {-1., -1.}, {-1., 1.}}) {
        const Vec3 direction = sign * (normal + tilt * aside + skew).normalized();
        // Back through the wall too: another that touches it there may lie closer than `off`.
        const bool through = sign != from;
        // None farther than the nearest so far.
        const auto hits = rays_->along(point + from * off, direction, inside.depth);
        const auto wall = std::find_if(hits.begin(), hits.end(), [&](const RayHit& hit) {
          // Neither the fans that close ends nor the wall that the ray passes through.
          return hit.triangle < surface_.triangles.rows() && counts(hit) &&
                 (!through || (surface_.triangles.row(hit.triangle).array() != v).all());
        });
        if (wall != hits.end() && wall->distance < inside.depth)
          inside = {bodies_of_triangles_[index(wall->triangle)], wall->distance};
      }
    return inside;
  }

 private:
  TriangleSurface surface_;
  std::vector<int> first_point_, first_triangle_;
  Points normals_;
  std::vector<int> bodies_of_triangles_;
  std::optional<RayHits> rays_;
};

// Whole::depth_of() of each vertex of a body.
std::vector<Inside> depths_of(const Whole& now, int body, int vertices, double edge) {
  constexpr int share = 256;  // of the vertices, on one thread
  std::vector<Inside> depths(index(vertices));
  in_parallel(threads(), (vertices + share - 1) / share, [&](int part) {
    for (int v = part * share; v < std::min(vertices, (part + 1) * share); ++v)
      depths[index(v)] = now.depth_of(body, v, edge);
  });
  return depths;
}

}  // namespace

std::vector<Crossing> crossings(const std::vector<CheckedBody>& bodies, const CheckedSeam& seam,
                                double tolerance) {
  const bool finite = std::all_of(bodies.begin(), bodies.end(),
                                  [](const CheckedBody& body) { return body.now->allFinite(); });
  if (!finite || bodies.empty()) return {};
  Whole now(bodies, true);
  if (seam.a >= 0 && seam.b >= 0) now.weld(seam);
  // What did not move passes through nothing that it did not pass through at rest.
  std::vector<char> moved;
  moved.reserve(bodies.size());
  for (const CheckedBody& body : bodies) moved.push_back(*body.now != body.rest->points ? 1 : 0);
  auto pairs = now.crossing_pairs(moved);
  const auto obstacle = [&](int body) { return !(bodies[index(body)].radius > 0); };
  std::erase_if(
      pairs, [&](const auto& pair) { return obstacle(pair.first[0]) && obstacle(pair.first[1]); });
  if (pairs.empty()) return {};
  std::set<int> involved;
  for (const auto& [between, count] : pairs) involved.insert(between.begin(), between.end());
  now.close();
  std::optional<Whole> rest;
  std::map<std::array<int, 2>, Crossing> found;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const int body = static_cast<int>(i);
    if (!involved.contains(body)) continue;
    const double edge = mean_edge_length({*bodies[i].now, bodies[i].rest->triangles});
    const std::vector<Inside> depths =
        depths_of(now, body, static_cast<int>(bodies[i].rest->points.rows()), edge);
    for (int v = 0; v < std::ssize(depths); ++v) {
      const Inside& inside = depths[index(v)];
      if (inside.body < 0) continue;
      const auto [a, b] = std::minmax(body, inside.body);
      const auto crossing_pairs = pairs.find({a, b});
      if (crossing_pairs == pairs.end()) continue;  // enclosed without touching
      double radius = std::numeric_limits<double>::infinity();
      for (const CheckedBody* other : {&bodies[index(a)], &bodies[index(b)]})
        if (other->radius > 0) radius = std::min(radius, other->radius);
      const double least = edge * edge / (4 * radius) + tolerance * edge;
      Crossing& crossing = found[{a, b}];
      if (!(inside.depth > std::max(least, crossing.depth))) continue;
      if (!rest) rest.emplace(bodies, false).close();
      // A wall of a third body may have been nearer at rest.
      const Inside before = rest->depth_of(body, v, edge, inside.body);
      if (before.body == inside.body && inside.depth < before.depth + least) continue;
      crossing = {a, b, crossing_pairs->second, bodies[i].now->row(v), inside.depth};
    }
  }
  std::vector<Crossing> out;
  for (const auto& [between, crossing] : found)
    if (crossing.pairs > 0) out.push_back(crossing);
  return out;
}

}  // namespace vasorod
