#include "prepare/part_walls.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "data/index.h"
#include "geometry/ray_hits.h"
#include "geometry/triangle_surface.h"
#include "prepare/repair.h"
#include "surface_file/check_surface.h"

namespace vasorod {
namespace {

constexpr int rim = -1;  // in place of a part's or a side's number

class WallParts {
 public:
  explicit WallParts(const TriangleSurface& surface)
      : surface_(surface), part_(index(surface.triangles.rows()), rim), opposite_(part_) {
    for (int t = 0; t < surface.triangles.rows(); ++t)
      normal_.push_back(triangle_normal(surface, t).normalized());
    beside_.resize(part_.size());
    for (const Edge& edge : edges_of(surface.triangles))
      if (!edge.boundary()) {
        beside_[index(edge.triangle[0])].push_back(edge.triangle[1]);
        beside_[index(edge.triangle[1])].push_back(edge.triangle[0]);
      }
    number_faces(face_triangles());
    two_sides();
    grow_to_creases();
    take_in_islands();
  }

  double thickness() const { return thickness_; }

  std::vector<TriangleSurface> parts() const {
    std::vector<TriangleSurface> out;
    for (const std::vector<int>& own : triangles_of_parts())
      if (!own.empty()) out.push_back(part_with(surface_, own));
    return out;
  }

 private:
  std::vector<std::vector<int>> triangles_of_parts() const {
    std::vector<std::vector<int>> triangles(index(count_));
    for (int t = 0; t < surface_.triangles.rows(); ++t)
      if (part_[index(t)] != rim) triangles[index(part_[index(t)])].push_back(t);
    return triangles;
  }

  // Which triangles have the other face behind them.
  std::vector<char> face_triangles() {
    const RayHits rays(surface_);
    const double skip = 1e-6 * mean_edge_length(surface_);
    std::vector<double> behind(part_.size(), std::numeric_limits<double>::infinity()), found;
    std::vector<RayHit> hits;
    for (std::size_t t = 0; t < part_.size(); ++t) {
      rays.along(triangle_center(surface_, static_cast<int>(t)) - skip * normal_[t], -normal_[t],
                 std::numeric_limits<double>::infinity(), hits);
      // The first wall behind, which faces the other way by less than 60 degrees.
      if (hits.empty() || normal_[index(hits.front().triangle)].dot(normal_[t]) > -0.5) continue;
      behind[t] = hits.front().distance;
      opposite_[t] = hits.front().triangle;
      found.push_back(behind[t]);
    }
    std::vector<char> face(part_.size(), 0);
    if (found.empty()) return face;
    const auto middle = found.begin() + static_cast<std::ptrdiff_t>(found.size() / 2);
    std::nth_element(found.begin(), middle, found.end());
    thickness_ = *middle;
    for (std::size_t t = 0; t < face.size(); ++t) face[t] = behind[t] < 3 * thickness_ ? 1 : 0;
    return face;
  }

  void number_faces(const std::vector<char>& face) {
    for (int seed = 0; seed < static_cast<int>(part_.size()); ++seed) {
      if (!face[index(seed)] || part_[index(seed)] != rim) continue;
      std::vector<int> all{seed};
      part_[index(seed)] = count_;
      for (std::size_t next = 0; next < all.size(); ++next)
        for (const int u : beside_[index(all[next])])
          if (face[index(u)] && part_[index(u)] == rim && !folded_between(all[next], u)) {
            part_[index(u)] = count_;
            all.push_back(u);
          }
      ++count_;
    }
  }

  // The parts, from large to small, each on the side that those behind it are not on: an edge along
  // the wall may part one side into several.
  void two_sides() {
    auto triangles = triangles_of_parts();
    std::stable_sort(triangles.begin(), triangles.end(),
                     [](const auto& a, const auto& b) { return a.size() > b.size(); });
    std::vector<int> side(part_.size(), rim);
    bool first = true;
    for (const auto& part : triangles) {
      std::array<int, 2> behind{0, 0};
      for (const int t : part)
        if (const int found = side[index(opposite_[index(t)])]; found != rim)
          ++behind[index(found)];
      if (!first && behind[0] == behind[1]) continue;
      for (const int t : part) side[index(t)] = behind[0] > behind[1] ? 1 : 0;
      first = false;
    }
    part_ = std::move(side);
    count_ = 2;
  }

  // The faces take what continues them smoothly: up to the crease at a flat rim, or up to where a
  // round one has turned by 30 degrees.
  void grow_to_creases() {
    const std::vector<int> faces = part_;
    std::vector<int> front, seed(part_.size());
    for (int t = 0; t < static_cast<int>(part_.size()); ++t)
      if (part_[index(t)] != rim) {
        front.push_back(t);
        seed[index(t)] = t;
      }
    for (std::size_t next = 0; next < front.size(); ++next) {
      const int t = front[next];
      for (const int u : beside_[index(t)])
        if (part_[index(u)] == rim && smooth_between(t, u) && smooth_between(seed[index(t)], u)) {
          part_[index(u)] = part_[index(t)];
          seed[index(u)] = seed[index(t)];
          front.push_back(u);
        }
    }
    // What hangs on one edge alone belongs to the rim.
    for (auto t = front.rbegin(); t != front.rend(); ++t)
      if (faces[index(*t)] == rim &&
          std::count_if(beside_[index(*t)].begin(), beside_[index(*t)].end(),
                        [&](int u) { return part_[index(u)] == part_[index(*t)]; }) < 2)
        part_[index(*t)] = rim;
  }

  // What is left between creases and has one side along most of its border belongs to that side.
  void take_in_islands() {
    std::vector<char> seen(part_.size(), 0);
    for (int first = 0; first < static_cast<int>(part_.size()); ++first) {
      if (part_[index(first)] != rim || seen[index(first)]) continue;
      std::vector<int> all{first};
      seen[index(first)] = 1;
      std::array<int, 2> along{0, 0};
      int border = 0;
      for (std::size_t next = 0; next < all.size(); ++next) {
        const auto& beside = beside_[index(all[next])];
        border += 3 - static_cast<int>(beside.size());
        for (const int u : beside) {
          if (part_[index(u)] == rim && smooth_between(all[next], u)) {
            if (!seen[index(u)]) all.push_back(u);
            seen[index(u)] = 1;
            continue;
          }
          ++border;
          if (part_[index(u)] != rim) ++along[index(part_[index(u)])];
        }
      }
      for (const int side : {0, 1})
        if (2 * along[index(side)] > border && along[index(1 - side)] == 0)
          for (const int t : all) part_[index(t)] = side;
    }
  }

  bool folded_between(int t, int u) const {
    return normal_[index(t)].dot(normal_[index(u)]) < -0.5;
  }

  bool smooth_between(int t, int u) const {
    return normal_[index(t)].dot(normal_[index(u)]) > std::cos(30 * M_PI / 180);
  }

  const TriangleSurface& surface_;
  std::vector<int> part_, opposite_;  // of a triangle; the one behind it
  std::vector<Vec3> normal_;          // unit
  std::vector<std::vector<int>> beside_;
  int count_ = 0;
  double thickness_ = 0;
};

}  // namespace

std::optional<PartedWall> part_walls(const TriangleSurface& surface) {
  const WallParts walls(surface);
  TriangleSurface all;
  for (TriangleSurface part : walls.parts()) {
    orient(part);  // points where two of its boundaries met
    append(all, part);
  }
  if (all.triangles.rows() == 0) return std::nullopt;
  const std::vector<LeftOut> others = keep_largest(all);
  const double volume = lidded_volume(all);
  const bool inner = std::any_of(others.begin(), others.end(), [&](const LeftOut& part) {
    return part.inside && part.volume > 0.1 * volume;
  });
  if (!inner || handles_of(all) != 0) return std::nullopt;
  return PartedWall{std::move(all), walls.thickness()};
}

}  // namespace vasorod
