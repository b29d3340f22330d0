#include "geometry/crossing_triangles.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <algorithm>
#include <atomic>
#include <limits>

#include "data/index.h"
#include "geometry/box_tree.h"

namespace vasorod {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point3 = Kernel::Point_3;

class Corners {
 public:
  explicit Corners(const TriangleSurface& surface) : triangles_(surface.triangles) {
    points_.reserve(index(surface.points.rows()));
    for (const auto point : surface.points.rowwise())
      points_.emplace_back(point.x(), point.y(), point.z());
  }

  bool flat(int t) const { return CGAL::collinear(at(t, 0), at(t, 1), at(t, 2)); }

  bool cross(int s, int t) const {
    // Corners of s and t that are one vertex.
    int shared = 0;
    std::array<int, 2> in_s{}, in_t{};
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        if (triangles_(s, i) == triangles_(t, j) && shared < 2) {
          in_s[index(shared)] = i;
          in_t[index(shared)] = j;
          ++shared;
        }
    if (shared == 2) return folded(s, t, 3 - in_s[0] - in_s[1], 3 - in_t[0] - in_t[1]);
    if (shared == 0) return CGAL::do_intersect(triangle(s), triangle(t));
    return CGAL::do_intersect(triangle(s), opposite(t, in_t[0])) ||
           CGAL::do_intersect(triangle(t), opposite(s, in_s[0]));
  }

 private:
  const Point3& at(int t, int k) const { return points_[index(triangles_(t, k % 3))]; }
  Kernel::Triangle_3 triangle(int t) const { return {at(t, 0), at(t, 1), at(t, 2)}; }
  Kernel::Segment_3 opposite(int t, int k) const { return {at(t, k + 1), at(t, k + 2)}; }

  // Neighbours over an edge overlap only where they lie in one plane on the same side of it. i and
  // j: the corners off the edge.
  bool folded(int s, int t, int i, int j) const {
    const Point3 &a = at(s, i + 1), &b = at(s, i + 2), &c = at(s, i), &d = at(t, j);
    return CGAL::coplanar(a, b, c, d) && CGAL::coplanar_orientation(a, b, c, d) == CGAL::POSITIVE;
  }

  const Triangles& triangles_;
  std::vector<Point3> points_;
};

}  // namespace

std::vector<std::array<int, 2>> crossing_triangles(const TriangleSurface& surface,
                                                   const std::vector<char>& moved, std::size_t most,
                                                   int threads) {
  using Pairs = std::vector<std::array<int, 2>>;
  const Corners corners(surface);
  Pairs pairs;
  std::vector<char> flat(index(surface.triangles.rows()));
  for (int t = 0; t < surface.triangles.rows(); ++t) {
    flat[index(t)] = corners.flat(t) ? 1 : 0;
    if (flat[index(t)] && moved[index(t)]) pairs.push_back({t, t});
  }
  std::vector<Pairs> found;
  // The first part that alone has enough: those after it are not asked for.
  std::atomic<std::size_t> last = std::numeric_limits<std::size_t>::max();
  BoxTree(triangle_boxes(surface))
      .meeting_pairs(
          moved, threads, [&](std::size_t parts) { found.resize(parts); },
          [&](std::size_t part, int s, int t) {
            if (part > last) return false;
            if (!flat[index(s)] && !flat[index(t)] && corners.cross(s, t))
              found[part].push_back({std::min(s, t), std::max(s, t)});
            if (found[part].size() < most) return true;
            std::size_t before = last;
            while (part < before && !last.compare_exchange_weak(before, part)) {
            }
            return false;
          });
  for (const Pairs& more : found) pairs.insert(pairs.end(), more.begin(), more.end());
  pairs.resize(std::min(pairs.size(), most));
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

std::vector<std::array<int, 2>> self_intersections(const TriangleSurface& surface) {
  return crossing_triangles(surface, std::vector<char>(index(surface.triangles.rows()), 1),
                            most_self_intersections);
}

}  // namespace vasorod
