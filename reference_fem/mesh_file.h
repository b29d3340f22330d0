// Meshes of a tube's wall from gmsh files, read by deal.II: hexahedra for the solid, quadrilaterals
// of the mid-wall for the shell, in any order and grading. The file gives the cells; the geometry
// is the scene's tube, exact: every vertex is pulled back to the tube's parameters, and whatever
// does not lie on the tube is refused.
#pragma once

#include <string>

#include "reference_fem/mesh.h"
#include "reference_fem/tube.h"

namespace vasorod::fem {

struct MeshFile {
  std::string path;
  double length_unit = 1;  ///< the file's lengths per the tube's
  int halvings = 0;        ///< refinements of every cell into 2^dim
};

/// gmsh's ASCII formats 2.2 and 4.1. The file's axes are the start section's: origin at its centre,
/// the axis along +z, turning towards +x (meshes/tube.py writes so). Physical tags, if any, must be
/// 1 start, 2 end, 3 inner and 4 outer wall. Throws InputError with the file, what was found and
/// what is expected; FileError where it cannot be opened.
Mesh read_solid(const MeshFile& file, const TubeShape& tube, int degree,
                const Processes& processes = {});
Mesh read_surface(const MeshFile& file, const TubeShape& tube, int degree,
                  const Processes& processes = {});

/// Cells around and along; of an unstructured mesh their nearest whole equivalents.
struct CellCount {
  int around = 0, along = 0;
};
CellCount count_cells(const Mesh& mesh);

}  // namespace vasorod::fem
