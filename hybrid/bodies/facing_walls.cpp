#include "bodies/facing_walls.h"

#include <Eigen/Geometry>
#include <cmath>
#include <limits>

#include "data/index.h"
#include "geometry/closest_point.h"
#include "geometry/fans.h"
#include "geometry/triangle_surface.h"

namespace vasorod {
namespace {

// Walls face each other if their normals are opposite within 60 degrees.
constexpr double facing = -0.5;
// The ray that counts crossings leaves the normal by this slope, in no mesh's direction: a ray
// through a vertex or an edge hits several triangles at once.
constexpr double slope_1 = 0.0137, slope_2 = 0.0071;

}  // namespace

FacingWalls::FacingWalls(const TriangleSurface& surface)
    : now_(surface),
      loops_(boundary_loops(surface.triangles)),
      closed_{with_centroids(surface.points, loops_),
              with_fans(surface.triangles, loops_, surface.points.rows())},
      normals_(vertex_normals(surface)),
      rays_(closed_) {}

void FacingWalls::refit(const Points& points) {
  now_.points = points;
  closed_.points = with_centroids(points, loops_);
  normals_ = vertex_normals(now_);
  rays_.refit(closed_.points);
}

std::array<int, 3> FacingWalls::corners_of(int triangle) const {
  const auto row = closed_.triangles.row(triangle);
  return {row[0], row[1], row[2]};
}

FacingWall FacingWalls::wall_at(int triangle, const Vec3& at) const {
  FacingWall wall;
  wall.triangle = triangle;
  wall.corner = corners_of(triangle);
  wall.at = at;
  const auto& [a, b, c] = wall.corner;
  wall.weight = closest_in_triangle(at, now_.points.row(a), now_.points.row(b), now_.points.row(c));
  wall.normal = (wall.weight[0] * normals_.row(a) + wall.weight[1] * normals_.row(b) +
                 wall.weight[2] * normals_.row(c))
                    .transpose();
  const double length = wall.normal.norm();
  // A fold has no outside.
  wall.normal = length > 0.1 ? Vec3(wall.normal / length) : Vec3(Vec3::Zero());
  return wall;
}

bool FacingWalls::faces(const FacingWall& wall, const Vec3& normal) const {
  return wall.normal.dot(normal) < facing;
}

int FacingWalls::winding_outside(int vertex) const {
  const Vec3 normal = normals_.row(vertex);
  const Vec3 across = normal.unitOrthogonal();
  const Vec3 direction = (normal + slope_1 * across + slope_2 * normal.cross(across)).normalized();
  rays_.along_from(vertex, direction, std::numeric_limits<double>::infinity(), hits_);
  int winding = 0;
  for (const RayHit& hit : hits_) winding += hit.leaves ? 1 : -1;
  return winding;
}

}  // namespace vasorod
