// The pieces of a VTP file as one surface.
#pragma once

#include <vector>

#include "surface_file/surface_file.h"

namespace vasorod {

/// Joins the pieces (at least one): points piece by piece, cells kind by kind. Arrays that not all
/// pieces have are left out. The space is that of the first piece.
SurfaceFile joined_pieces(std::vector<SurfaceFile> pieces);

}  // namespace vasorod
