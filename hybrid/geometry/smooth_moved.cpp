#include "geometry/smooth_moved.h"

#include "data/index.h"
#include "geometry/triangle_surface.h"

namespace vasorod {
namespace {

// Share of the way in one round; all of it would let neighbours swing against each other.
constexpr double share = 0.7;

}  // namespace

void smooth_moved(const TriangleSurface& rest, const std::vector<int>& chosen, int rounds,
                  MovedSurface& moved) {
  std::vector<std::vector<int>> neighbours(index(rest.points.rows()));
  for (const Edge& edge : edges_of(rest.triangles)) {
    neighbours[index(edge.a)].push_back(edge.b);
    neighbours[index(edge.b)].push_back(edge.a);
  }
  const auto from_neighbours = [&](const Points& points, int vertex) {
    Vec3 mean = Vec3::Zero();
    for (const int n : neighbours[index(vertex)]) mean += points.row(n).transpose();
    return Vec3(points.row(vertex).transpose() -
                mean / static_cast<double>(neighbours[index(vertex)].size()));
  };
  for (int round = 0; round < rounds; ++round) {
    const Points before = moved.points;
    for (const int i : chosen) {
      const Vec3 off = from_neighbours(before, i),
                 wanted = moved.rotations[index(i)] * from_neighbours(rest.points, i);
      moved.points.row(i) += share * (wanted - off).transpose();
    }
  }
}

}  // namespace vasorod
