#include "geometry/smooth_moved.h"

#include "data/index.h"
#include "geometry/triangle_surface.h"
#include "geometry/umbrella.h"

namespace vasorod {
namespace {

// Share of the way in one round; all of it would let neighbours swing against each other.
constexpr double share = 0.7;

}  // namespace

void smooth_moved(const TriangleSurface& rest, const std::vector<int>& chosen, int rounds,
                  MovedSurface& moved) {
  const Umbrella umbrella(edges_of(rest.triangles), static_cast<int>(rest.points.rows()));
  const Points at_rest = umbrella.apply(rest.points);
  for (int round = 0; round < rounds; ++round) {
    const Points now = umbrella.apply(moved.points);
    for (const int i : chosen) {
      const Vec3 wanted = moved.rotations[index(i)] * at_rest.row(i).transpose();
      moved.points.row(i) += share * (now.row(i) - wanted.transpose());
    }
  }
}

}  // namespace vasorod
