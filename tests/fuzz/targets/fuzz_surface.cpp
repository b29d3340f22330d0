// The input as a surface file: read, cleaned, opened and checked as in a scene. One program per
// format; VASOROD_FUZZ_ENDING is the file's ending.
#include "fuzz/targets/fuzz_input.h"
#include "surface_file/read_surface.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace vasorod;
  static const fuzz::fs::path file = fuzz::folder() / ("vessel." VASOROD_FUZZ_ENDING);
  fuzz::write_file(file, fuzz::text_of(data, size));
  fuzz::accepted([] {
    const LoadedSurface loaded = load_surface({.name = "vessel", .surface = file}, Scene());
    const auto& [points, triangles] = loaded.surface;
    if (!points.allFinite()) fuzz::finding("a point that is not finite");
    if (triangles.rows() == 0) fuzz::finding("no triangle");
    if (triangles.minCoeff() < 0 || triangles.maxCoeff() >= points.rows())
      fuzz::finding("a triangle with a point that does not exist");
    for (const NamedArray& array : loaded.point_arrays)
      if (array.values.rows() != points.rows()) fuzz::finding("a point array of another length");
    for (const NamedArray& array : loaded.cell_arrays)
      if (array.values.rows() != triangles.rows()) fuzz::finding("a cell array of another length");
  });
  return 0;
}
