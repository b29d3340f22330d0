// Finds and removes the flat lids that models from SimVascular and VMTK have over a vessel's ends.
#pragma once

#include "surface_file/read_surface.h"

namespace vasorod {

/// A lid is a flat, round disk of triangles behind a crease: connected, all normals within 10
/// degrees of their mean, one border of at least six edges with 4 pi area / perimeter^2 above 0.5
/// (an ellipse of axes 1 : 4.5; a facet of a coarse tube is a longer strip), and more than 30
/// degrees to the triangle across every border edge. Where the file names faces (cell array
/// ModelFaceID, CapID or CellEntityIds), it separates the faces instead of creases. Lids that
/// share a point are kept. The lids taken off are listed; their number goes into the report.
void open_caps(LoadedSurface& loaded);

}  // namespace vasorod
