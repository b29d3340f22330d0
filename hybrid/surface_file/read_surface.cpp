#include "surface_file/read_surface.h"

#include <cmath>
#include <stdexcept>

#include <vasorod/error.h>

#include "data/sentence.h"
#include "geometry/triangle_surface.h"
#include "surface_file/check_surface.h"
#include "surface_file/clean_surface.h"
#include "surface_file/open_caps.h"
#include "surface_file/read_polydata.h"
#include "surface_file/remesh.h"

namespace vasorod {

namespace {

std::string counted(int count, const std::string& one, const std::string& many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

void remesh_loaded(const std::string& file, double edge, LoadedSurface& loaded, Role role) {
  const double radius = typical_radius(loaded.surface);
  if (edge > radius || edge < radius / 200) {
    throw InputError(joined_text(file, ": remesh: found a target edge of ", edge, ", expected ",
                                 radius / 200, " to ", radius, ", from 1/200 to 1 of the radius"));
  }
  // Finer than any mesh of a vessel; far more would exhaust the memory.
  constexpr double most_triangles = 4e6;
  const double triangles = total_area(loaded.surface) / (std::sqrt(3) / 4 * edge * edge);
  if (!(triangles < most_triangles))
    throw InputError(file + ": remesh: found a target edge of " + number_text(edge) +
                     " that takes " + number_text(triangles, 2) + " triangles, expected at most " +
                     number_text(most_triangles));
  loaded.surface = remesh(loaded.surface, edge);
  loaded.report.remeshed = edge;
  for (const auto* arrays : {&loaded.point_arrays, &loaded.cell_arrays})
    for (const NamedArray& array : *arrays) loaded.report.dropped_arrays.push_back(array.name);
  loaded.point_arrays.clear();
  loaded.cell_arrays.clear();
  check_manifold(file + " remeshed", loaded.surface);
  check_ends(file + " remeshed", loaded.surface, role);
  check_self_intersections(file + " remeshed", loaded.surface);
}

}  // namespace

std::vector<std::string> SurfaceReport::lines() const {
  std::vector<std::string> out;
  auto say = [&](int count, const char* one, const char* many) {
    if (count > 0) out.push_back(counted(count, one, many));
  };
  say(skipped_cells, "vertex or line left out", "vertices and lines left out");
  say(merged_points, "doubled point welded", "doubled points welded");
  say(dropped_points, "point without triangles dropped", "points without triangles dropped");
  say(removed_triangles, "triangle that used a point twice removed",
      "triangles that used a point twice removed");
  say(collapsed_edges, "degenerate edge collapsed", "degenerate edges collapsed");
  say(straightened, "flat triangle straightened", "flat triangles straightened");
  say(removed_caps, "lid over an end removed", "lids over ends removed");
  if (remeshed) out.push_back(joined_text("remeshed to an edge of ", *remeshed));
  if (!dropped_arrays.empty()) {
    std::string line = "the file's arrays dropped by remeshing:";
    for (const std::string& name : dropped_arrays) line += " " + name;
    out.push_back(line);
  }
  return out;
}

std::string SurfaceReport::text() const {
  std::string all;
  for (const std::string& line : lines()) all += (all.empty() ? "" : "; ") + line;
  return all.empty() ? "unchanged" : all;
}

LoadedSurface load_surface(const VesselSpec& vessel, const Scene& scene) {
  if (vessel.tube) {
    LoadedSurface loaded;
    loaded.surface = tube_surface(*vessel.tube);
    if (vessel.wall && vessel.tube->end_thickness)
      loaded.thickness = tube_thickness(*vessel.tube, vessel.wall->thickness);
    return loaded;
  }
  if (!vessel.surface) throw std::logic_error("load_surface: a bare rod has no surface");
  const std::string file = vessel.surface->string();
  LoadedSurface loaded = read_polydata(*vessel.surface);
  check_manifold(file, loaded.surface);
  clean_surface(loaded);
  if (vessel.role == Role::deformable) open_caps(loaded);
  check_ends(file, loaded.surface, vessel.role);
  check_outward(file, loaded.surface);
  if (vessel.check) check_unit(file, loaded.surface, scene.units);
  check_self_intersections(file, loaded.surface);
  if (vessel.remesh) remesh_loaded(file, *vessel.remesh, loaded, vessel.role);
  return loaded;
}

}  // namespace vasorod
