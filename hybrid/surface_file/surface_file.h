// A surface file as it was read, before anything is checked or cut into triangles.
#pragma once

#include <filesystem>
#include <vector>

#include <vasorod/named_array.h>
#include <vasorod/types.h>

namespace vasorod {

enum class SurfaceFormat { vtp, stl, ply, obj };

struct SurfaceFile {
  Points points;
  int skipped_cells = 0;  ///< vertices and lines; their rows come first in cell_arrays
  std::vector<std::vector<int>> polygons,
      strips;  ///< point numbers as the file says, -1 for what is none
  std::vector<NamedArray> point_arrays, cell_arrays;
};

/// VTP and STL through VTK, whose own messages go into the InputError of a damaged file and nowhere
/// else.
SurfaceFile read_vtk(const std::filesystem::path& file, SurfaceFormat format);

/// PLY (Turk 1994), ascii and binary in both byte orders. Not through VTK, whose reader crashes on
/// damaged files.
SurfaceFile read_ply(const std::filesystem::path& file);

/// Wavefront OBJ: points and faces; texture, normals, groups and materials are left. Not through
/// VTK, whose reader crashes on damaged files and doubles points that have several normals.
SurfaceFile read_obj(const std::filesystem::path& file);

}  // namespace vasorod
