// A surface file as it was read, before it is checked and cut into triangles.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <vasorod/named_array.h>
#include <vasorod/types.h>

namespace vasorod {

enum class SurfaceFormat { vtp, stl, ply, obj };

struct SurfaceFile {
  Points points;
  int skipped_cells = 0;  ///< vertices and lines; their rows come first in cell_arrays
  std::vector<std::vector<int>> polygons, strips,
      lines;  ///< point numbers as in the file; -1 if not representable
  std::vector<NamedArray> point_arrays, cell_arrays;
  std::string space;  ///< LPS or RAS where the file says so (space.h)
};

/// VTP in every encoding, uncompressed or packed with zlib, LZ4 or LZMA; several pieces become one.
/// Not through VTK, whose reader crashes, hangs or takes all memory on damaged files. Every array
/// has one row per point or cell and lies within the file.
SurfaceFile read_vtp(const std::filesystem::path& file);

/// The unit of length, mm, cm or m, in the field data Units of a VTP file ("length mm, stress MPa",
/// as this program writes it); nothing where there is none.
std::string units_in_vtp(const std::filesystem::path& file);

/// STL, ascii and binary. A binary file is exactly as long as its number of facets says.
SurfaceFile read_stl(const std::filesystem::path& file);

/// PLY (Turk 1994), ascii and binary in both byte orders. Not through VTK, whose reader crashes on
/// damaged files.
SurfaceFile read_ply(const std::filesystem::path& file);

/// Wavefront OBJ: points and faces; texture, normals, groups and materials are ignored. Not through
/// VTK, whose reader crashes on damaged files and doubles points that have several normals.
SurfaceFile read_obj(const std::filesystem::path& file);

}  // namespace vasorod
