// Checks gmsh files for what deal.II's reader does not check: it silently misreads binary files,
// unknown versions and several physical groups on one entity, and reports an unsupported element as
// a number only.
#pragma once

#include <string>

namespace vasorod::fem {

/// Throws InputError unless the file is ASCII, version 2.2 or 4.1, contains first-order cells of
/// dimension `dim` (3: hexahedra, 2: quadrilaterals) and no other elements of that dimension, and
/// has at most one physical group per entity. FileError if the file cannot be opened.
void check_msh(const std::string& path, int dim);

}  // namespace vasorod::fem
