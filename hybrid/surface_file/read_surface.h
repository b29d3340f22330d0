// Surfaces of a scene: read, cleaned, opened, checked, remeshed where asked; or generated.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <vasorod/named_array.h>
#include <vasorod/scene.h>
#include <vasorod/types.h>

namespace vasorod {

/// What reading changed.
struct SurfaceReport {
  int merged_points = 0;      ///< exact duplicates welded (STL, whose triangles share no points)
  int dropped_points = 0;     ///< belonged to no triangle
  int removed_triangles = 0;  ///< used a point twice
  int collapsed_edges = 0;    ///< shorter than 1e-3 of the mean edge
  int straightened =
      0;  ///< triangles flatter than 1e-3 of the mean edge, cured by turning their longest edge
  int removed_caps = 0;                     ///< flat lids over ends
  int skipped_cells = 0;                    ///< vertices and lines of the file
  std::optional<double> remeshed;           ///< target edge, scene's length unit
  std::vector<std::string> dropped_arrays;  ///< by remeshing: they belong to points that are gone

  std::vector<std::string> lines()
      const;                 ///< one phrase per change; empty when nothing was changed
  std::string text() const;  ///< the lines as one sentence, "unchanged" when there are none
};

/// A surface as the solvers take it: manifold, oriented outwards, one component; a deformable
/// vessel has two or more open ends. Points are in the input's order unless remeshed; then each
/// end's points come first, ends in input order.
struct LoadedSurface {
  TriangleSurface surface;
  std::vector<NamedArray> point_arrays, cell_arrays;  ///< the input's own; empty after remeshing
  std::optional<Eigen::VectorXd> thickness;  ///< per vertex, where a generated tube's wall tapers
  SurfaceReport report;
};

/// Reads or generates the surface of `vessel`. Throws InputError (a sentence with the file) on what
/// is no such surface, and on a radius that is not 0.5 to 50 mm in the scene's unit unless the
/// vessel says check: false.
LoadedSurface load_surface(const VesselSpec& vessel, const Scene& scene);

}  // namespace vasorod
