// Reads meshes of a tube's wall from gmsh files through deal.II: hexahedra for the solid,
// quadrilaterals of the mid-wall for the shell, in any order and grading. The file gives only the
// cells. The geometry is the scene's exact tube: every vertex is mapped back to the tube's
// parameters, and vertices off the tube are refused.
#pragma once

#include <string>

#include "reference_fem/mesh.h"
#include "reference_fem/tube.h"

namespace vasorod::fem {

/// A gmsh file and how to read it.
struct MeshFile {
  std::string path;
  double length_unit = 1;  ///< length unit of the file over that of the tube
  int halvings = 0;        ///< refinements of every cell into 2^dim
};

/// gmsh's ASCII formats 2.2 and 4.1. The file's axes are those of the start section: origin at its
/// centre, axis along +z, bending towards +x (as meshes/tube.py writes them). Physical tags, if
/// any, must be 1 start, 2 end, 3 inner and 4 outer wall. Throws InputError with the file, what was
/// found and what is expected; FileError if the file cannot be opened.
Mesh read_solid(const MeshFile& file, const TubeShape& tube, int degree,
                const Processes& processes = {});
Mesh read_surface(const MeshFile& file, const TubeShape& tube, int degree,
                  const Processes& processes = {});

/// Cells around and along; for an unstructured mesh, the nearest equivalent integers.
struct CellCount {
  int around = 0, along = 0;
};
CellCount count_cells(const Mesh& mesh);

}  // namespace vasorod::fem
