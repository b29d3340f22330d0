// One surface file as triangles: VTP in every encoding, STL, PLY or OBJ, recognised by the ending.
#pragma once

#include <filesystem>

#include "surface_file/read_surface.h"

namespace vasorod {

/// Cuts polygons and strips into triangles, with their rows of the arrays; welds STL and OBJ; drops
/// points without triangles. Throws InputError on a file that is missing, damaged, without
/// triangles or with points that are not finite.
LoadedSurface read_polydata(const std::filesystem::path& file);

/// Keeps the named rows of every array, in that order.
void keep_rows(std::vector<NamedArray>& arrays, const std::vector<int>& rows);

/// Drops points without triangles and renumbers, order kept; arrays follow. Returns how many were
/// dropped.
int drop_unused_points(LoadedSurface& loaded);

/// Keeps the named triangles; cell arrays follow.
void keep_triangles(LoadedSurface& loaded, const std::vector<int>& rows);

}  // namespace vasorod
