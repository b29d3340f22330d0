#include "prepare/outer_wall.h"

#include <CGAL/alpha_wrap_3.h>
#include <algorithm>
#include <vector>

#include "geometry/closest_point.h"
#include "geometry/ray_hits.h"
#include "geometry/triangle_surface.h"
#include "prepare/repair.h"
#include "surface_file/cgal_surface.h"
#include "surface_file/check_surface.h"

namespace vasorod {

double facing_width(const TriangleSurface& surface) {
  const RayHits rays(surface);
  const double edge = mean_edge_length(surface);
  const auto n = static_cast<int>(surface.triangles.rows());
  std::vector<double> width;
  for (int t = 0; t < n; t += std::max(1, n / 2000)) {
    const Vec3 normal = triangle_normal(surface, t).normalized();
    for (const RayHit& hit : rays.along(triangle_center(surface, t) + 1e-3 * edge * normal, normal))
      if (!hit.leaves && hit.distance > edge) {
        width.push_back(hit.distance);
        break;
      }
  }
  if (width.empty()) return 0;
  std::nth_element(width.begin(), width.begin() + static_cast<std::ptrdiff_t>(width.size() / 2),
                   width.end());
  return width[width.size() / 2];
}

std::optional<OuterWall> outer_wall(const TriangleSurface& surface) {
  const CgalSoup soup = to_soup(surface);
  const double edge = mean_edge_length(surface), width = facing_width(surface);
  const ClosestPoint wall(surface);
  for (const double ball : {3 * edge, 0.6 * width, 0.9 * width, 1.4 * width}) {
    if (ball < 3 * edge) continue;
    const double offset = std::min(0.3 * edge, ball / 20);
    CgalMesh mesh;
    CGAL::alpha_wrap_3(soup.points, soup.faces, ball, offset, mesh);
    OuterWall out;
    out.surface = from_cgal(mesh);
    out.ball = ball;
    keep_largest(out.surface);
    if (handles_of(out.surface) != 0) continue;
    const Points normals = vertex_normals(out.surface);
    Eigen::Index lifted = 0;
    for (Eigen::Index i = 0; i < out.surface.points.rows(); ++i) {
      const Vec3 p = out.surface.points.row(i), n = normals.row(i);
      const auto hit = wall.query(p);
      const bool near = (hit.point - p).norm() < 2 * offset;
      lifted += near ? 0 : 1;
      out.surface.points.row(i) = near ? hit.point : Vec3(p - offset * n);
    }
    out.lifted = static_cast<double>(lifted) / static_cast<double>(out.surface.points.rows());
    return out;
  }
  return std::nullopt;
}

}  // namespace vasorod
