// Loads the surfaces of a scene: reads, cleans, opens, checks and remeshes them, or generates them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <vasorod/named_array.h>
#include <vasorod/scene.h>
#include <vasorod/types.h>

namespace vasorod {

/// What was changed while reading.
struct SurfaceReport {
  int merged_points = 0;      ///< exact duplicates welded (STL, whose triangles share no points)
  int dropped_points = 0;     ///< belonged to no triangle
  int removed_triangles = 0;  ///< used a point twice
  int collapsed_edges = 0;    ///< shorter than 1e-3 of the mean edge
  int straightened =
      0;  ///< triangles flatter than 1e-3 of the mean edge; their longest edge was flipped
  int removed_caps = 0;                     ///< flat lids over ends
  int skipped_cells = 0;                    ///< vertices and lines of the file
  std::optional<double> remeshed;           ///< target edge, scene's length unit
  std::vector<std::string> dropped_arrays;  ///< by remeshing, because their points no longer exist

  std::vector<std::string> lines()
      const;                 ///< one phrase per change; empty when nothing was changed
  std::string text() const;  ///< the lines as one sentence, "unchanged" when there are none
};

/// A lid that was taken off an end.
struct Lid {
  std::string name;            ///< its ModelFaceID; empty: the file has none
  Vec3 center = Vec3::Zero();  ///< mean of its triangles' centres, length
};

/// A surface as the solvers expect it: manifold, oriented outwards, one component; a deformable
/// vessel has two or more open ends. Points are in the input's order unless remeshed; then each
/// end's points come first, ends in input order.
struct LoadedSurface {
  TriangleSurface surface;
  std::vector<NamedArray> point_arrays, cell_arrays;  ///< the input's own; empty after remeshing
  std::optional<Eigen::VectorXd> thickness;  ///< per vertex, where a generated tube's wall tapers
  std::string space;                         ///< LPS or RAS where the file says so
  std::vector<Lid> lids;                     ///< those that were taken off
  SurfaceReport report;
};

/// Reads or generates the surface of `vessel`. Throws InputError (a sentence with the file) if it
/// does not meet these conditions or, unless the vessel has check: false, if its radius is not 0.5
/// to 50 mm.
LoadedSurface load_surface(const VesselSpec& vessel, const Scene& scene);

}  // namespace vasorod
