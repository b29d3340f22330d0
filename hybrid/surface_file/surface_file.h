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
  std::vector<std::vector<int>> polygons, strips,
      lines;  ///< point numbers as the file says, -1 for what is none
  std::vector<NamedArray> point_arrays, cell_arrays;
};

/// VTP in every encoding, uncompressed or packed with zlib, LZ4 or LZMA; several pieces become one.
/// Not through VTK, whose reader crashes, hangs or takes all memory on damaged files. Every array
/// is as long as its points or cells ask for and lies within the file.
SurfaceFile read_vtp(const std::filesystem::path& file);

/// STL, ascii and binary. A binary file is exactly as long as its number of facets says.
SurfaceFile read_stl(const std::filesystem::path& file);

/// PLY (Turk 1994), ascii and binary in both byte orders. Not through VTK, whose reader crashes on
/// damaged files.
SurfaceFile read_ply(const std::filesystem::path& file);

/// Wavefront OBJ: points and faces; texture, normals, groups and materials are left. Not through
/// VTK, whose reader crashes on damaged files and doubles points that have several normals.
SurfaceFile read_obj(const std::filesystem::path& file);

}  // namespace vasorod
