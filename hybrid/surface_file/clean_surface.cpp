#include "surface_file/clean_surface.h"

#include <algorithm>

#include "geometry/editable_mesh.h"
#include "geometry/triangle_surface.h"
#include "surface_file/read_polydata.h"

namespace vasorod {

namespace {

bool collapse_one(EditableMesh& mesh, int t, double shortest) {
  for (int k = 0; k < 3; ++k) {
    const int a = mesh.corner(t, k), b = mesh.corner(t, k + 1);
    if (mesh.length(a, b) < shortest && mesh.may_collapse(a, b)) {
      mesh.collapse(a, b);
      return true;
    }
  }
  return false;
}

bool straighten_one(EditableMesh& mesh, int t, double least) {
  int longest = 0;
  for (int k = 1; k < 3; ++k)
    if (mesh.length(mesh.corner(t, k), mesh.corner(t, k + 1)) >
        mesh.length(mesh.corner(t, longest), mesh.corner(t, longest + 1)))
      longest = k;
  const int a = mesh.corner(t, longest), b = mesh.corner(t, longest + 1);
  const auto both = mesh.on_edge(a, b);
  if (both.size() == 2) return mesh.turn(t, both[0] == t ? both[1] : both[0], a, b, least);
  // At an end the flat triangle is removed, and the end then passes through its third point,
  // unless that point is on an end already.
  if (mesh.on_boundary(mesh.corner(t, longest + 2))) return false;
  mesh.remove_triangle(t);
  return true;
}

bool has_degenerate(const TriangleSurface& surface, double least) {
  const auto areas = triangle_areas(surface);
  for (int t = 0; t < surface.triangles.rows(); ++t) {
    double longest = 0;
    for (int k = 0; k < 3; ++k)
      longest = std::max(longest, (surface.points.row(surface.triangles(t, k)) -
                                   surface.points.row(surface.triangles(t, (k + 1) % 3)))
                                      .norm());
    // A triangle with a short side has a small height too, so this finds both kinds.
    if (2 * areas[t] < least * longest) return true;
  }
  return false;
}

}  // namespace

void clean_surface(LoadedSurface& loaded) {
  const double least = degenerate_fraction * mean_edge_length(loaded.surface);
  if (!has_degenerate(loaded.surface, least)) return;
  EditableMesh mesh(loaded.surface);
  bool changed = true;
  // Terminates: every change removes a triangle or lifts one above the limit permanently.
  while (changed) {
    changed = false;
    for (int t = 0; t < mesh.triangle_count(); ++t) {
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
  mesh.store(loaded.surface);
  const auto rows = mesh.alive_triangles();
  if (static_cast<int>(rows.size()) == mesh.triangle_count()) return;
  keep_triangles(loaded, rows);
  drop_unused_points(loaded);
}

}  // namespace vasorod
