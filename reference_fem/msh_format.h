// What deal.II's reader takes on trust in a gmsh file, checked: it silently misreads binary files,
// unknown versions and several physical groups on one entity, and names an unsupported element by a
// bare number.
#pragma once

#include <string>

namespace vasorod::fem {

/// Throws InputError unless the file is ASCII, version 2.2 or 4.1, holds cells of dimension `dim`
/// (3: hexahedra, 2: quadrilaterals) of first order and nothing else of that dimension, and at most
/// one physical group on each entity. FileError where it cannot be opened.
void check_msh(const std::string& path, int dim);

}  // namespace vasorod::fem
